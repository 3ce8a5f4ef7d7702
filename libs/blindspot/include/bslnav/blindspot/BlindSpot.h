#pragma once

#include <mrpt/math/TPoint2D.h>

#include <cmath>

namespace bslnav {

/** The boundary of a place where a person could be hidden: the last visible point (BSBP). */
struct BlindSpot {
  mrpt::math::TPoint2D position;  ///< P^b, robot frame [m]
  double bearing_rad = 0.0;  ///< θ^b, direction of P^b from the robot's centre, in [−π, π]
  double range_m = 0.0;      ///< distance of P^b from the robot's centre

  static BlindSpot at(const mrpt::math::TPoint2D& position) {
    return {position, std::atan2(position.y, position.x), position.norm()};
  }
};

}  // namespace bslnav
