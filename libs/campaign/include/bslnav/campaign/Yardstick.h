#pragma once

#include <bslnav/planning/Guard.h>

#include <optional>

namespace bslnav {

/** A pass of a one-sided opening as its true geometry allows it: a corridor along x with an opening
 * in its right wall, behind which a person may stand; map frame. */
struct CornerPass {
  double right_m = 0.9, left_m = 1.5;  ///< from the line y = 0 to the walls, both positive
  double openingFrom_m = 3.5, openingTo_m = 5.0, depth_m = 2.0;
  double personRadius_m = 0.25;  ///< of the smallest disc that a person covers
  double goal_m = 7.5;           ///< the robot starts at the origin and stops at (goal, 0)
};

/** The least time [s] in which a robot can drive a pass so that it stands before anybody who may
 * step out reaches it: what no guard can beat.
 *
 * Dynamic programming over position along the corridor, offset across it and speed; the robot
 * drives straight between grid points (10 cm by 5 cm), turns at once, and sees everything that can
 * be seen.
 *  @param robot with the reaction time that the guard assumes, too
 *  @returns none when it cannot be driven at all: then the opening is too near to the walls */
std::optional<double> fastestPass_s(const CornerPass& pass, const StoppingAbility& robot,
                                    double acceleration_mps2, double maxSpeed_mps,
                                    double personSpeed_mps);

}  // namespace bslnav
