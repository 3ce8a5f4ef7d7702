#pragma once

#include <bslnav/simulation/SimulationEngine.h>

#include <string>

namespace bslnav {

/** A case as a world file of MVSim, MRPT's simulator: the same case gives the same bytes.
 *
 * Solids and people are blocks with the map's axes at their centre, named as their sections
 * (`wall:left`, `pedestrian:crossing`); the vehicle is `robot`. MVSim's lasers see every block
 * whatever its height, so a solid that no laser's plane meets is written as intangible: drawn, but
 * neither seen by lasers nor touched. People stand where they start, because a world file cannot
 * make them wait for the robot.
 *  @throws Error on a bad world, and on robots that MVSim does not have: holonomic ones, and
 * outlines of more than 14 corners */
std::string mvsimWorld(const SimulationCase& simulated);

/** The name of the block of a person. */
std::string mvsimPersonName(const std::string& pedestrian);

}  // namespace bslnav
