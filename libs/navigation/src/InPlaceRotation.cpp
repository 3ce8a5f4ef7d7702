#include <bslnav/navigation/InPlaceRotation.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>

namespace bslnav {

mrpt::math::TTwist2D rotateInPlace(double error_rad, const mrpt::math::TTwist2D& twist,
                                   const RobotLimits& limits, double period_s) {
  const double rate =
      std::min(limits.maxYawRate_radps,
               stoppingSpeed(std::abs(error_rad), limits.yawAcceleration_radps2, period_s));
  return limited({0.0, 0.0, std::copysign(rate, error_rad)}, twist, limits, period_s);
}

double bearingTo(const mrpt::math::TPose2D& from, const mrpt::math::TPoint2D& to) {
  return mrpt::math::wrapToPi(std::atan2(to.y - from.y, to.x - from.x) - from.phi);
}

bool isStanding(const mrpt::math::TTwist2D& twist) {
  return std::abs(twist.vx) < 0.02 && std::abs(twist.vy) < 0.02 && std::abs(twist.omega) < 0.05;
}

}  // namespace bslnav
