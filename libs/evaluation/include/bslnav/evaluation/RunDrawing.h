#pragma once

#include <bslnav/evaluation/RunTrace.h>
#include <bslnav/pictures/MapPicture.h>

#include <memory>
#include <string>

namespace bslnav {

/** How a run ended, in one line: outcome, time, what was hit, who came near. */
std::string outcomeLine(const RunSummary& summary);

/** What a picture of a setup's whole world shows: its map, else the way from start to goals. */
MapBounds boundsOf(const SimulationSetup& setup, const mrpt::maps::COccupancyGridMap2D* map);

/** Draws the world, the people's walks, the driven path by speed, start, goal and contact.
 *  @param map null for none */
void drawRun(MapPicture& picture, const SimulationSetup& setup,
             const mrpt::maps::COccupancyGridMap2D* map, const RunTrace& trace,
             const RunSummary& summary);

}  // namespace bslnav
