#pragma once

#include <bslnav/planning/RobotLimits.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>

namespace bslnav {

/** The command that brakes and turns on the spot by `error_rad` (positive: left) without
 * overshooting: the turning rate is the highest from which the robot can still stop at the wanted
 * heading. */
mrpt::math::TTwist2D rotateInPlace(double error_rad, const mrpt::math::TTwist2D& twist,
                                   const RobotLimits& limits, double period_s);

/** Heading from a pose to a point, relative to the pose's heading, in (−π, π]. */
double bearingTo(const mrpt::math::TPose2D& from, const mrpt::math::TPoint2D& to);

/** Whether the robot stands, but for sensor noise. */
bool isStanding(const mrpt::math::TTwist2D& twist);

}  // namespace bslnav
