#pragma once

#include <bslnav/costmap/CostGrid.h>
#include <bslnav/planning/Guard.h>

namespace bslnav {

/** What it costs in time to pass near a frontier, as costs for the global planner: a path of least
 * cost keeps away from places that nobody can see into by as much as pays off.
 *
 * At distance D from the frontier the guard lets a robot drive straight past at
 * v* = a·((D − radius − margin)/v_h − τ); a cell costs what makes a step of A* as much dearer as
 * the robot is slower there than at its highest speed.
 * @param costWeight of the global planner: a step costs length · (1 + costWeight · cost/252)
 * @param costs raised to these costs where they are lower; blocked and unknown cells stay */
void addGuardCosts(const Frontier& frontier, const GuardParameters& guard,
                   const StoppingAbility& robot, double maxSpeed_mps, double costWeight,
                   CostGrid& costs);

}  // namespace bslnav
