#pragma once

#include <bslnav/simulation/WorldParameters.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <memory>

namespace bslnav {

/** The map that a survey of the world would give, over its bounds and a margin around them.
 *
 * Cells that a mapped solid overlaps at the laser's height are occupied, all others free.
 * @throws Error on a bad world, a resolution that is not above 0 or a negative margin */
std::shared_ptr<mrpt::maps::COccupancyGridMap2D> staticMap(const WorldParameters& world,
                                                           double resolution_m,
                                                           double laserHeight_m, double margin_m);

}  // namespace bslnav
