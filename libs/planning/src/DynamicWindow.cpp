#include <bslnav/planning/DynamicWindow.h>

#include <algorithm>
#include <cmath>

namespace bslnav {

DynamicWindow dynamicWindow(const mrpt::math::TTwist2D& current, const RobotLimits& limits,
                            double window_s, double speedCap_mps) {
  const double turn = limits.maxYawRate_radps;
  const mrpt::math::TTwist2D forward{current.vx, 0.0, current.omega},
      sideways{0.0, current.vy, 0.0};
  const auto low = limited({0.0, 0.0, -turn}, forward, limits, window_s);
  const auto high = limited({speedCap_mps, 0.0, turn}, forward, limits, window_s);
  const double side = std::min(limits.maxLateralSpeed_mps, speedCap_mps);
  const auto right = limited({0.0, -side, 0.0}, sideways, limits, window_s);
  const auto left = limited({0.0, side, 0.0}, sideways, limits, window_s);
  return {low.vx, high.vx, low.omega, high.omega, right.vy, left.vy};
}

mrpt::math::TTwist2D withinWindow(mrpt::math::TTwist2D velocity,
                                  const mrpt::math::TTwist2D& current, const RobotLimits& limits,
                                  double window_s, double speedCap_mps) {
  if (limits.maxLateralSpeed_mps == 0.0 || (velocity.vy == 0.0 && current.vy == 0.0))
    return velocity;
  // A robot faster than the cap brakes straight: veering, too, would take from its deceleration.
  if (std::hypot(current.vx, current.vy) > speedCap_mps) {
    velocity.vx = current.vx;
    velocity.vy = current.vy;
  }
  const double speed = std::hypot(velocity.vx, velocity.vy);
  if (speed > speedCap_mps) {
    velocity.vx *= speedCap_mps / speed;
    velocity.vy *= speedCap_mps / speed;
  }
  return limited(velocity, current, limits, window_s);
}

double sampleOf(double low, double high, int i, int n) {
  if (n == 1) return low <= 0.0 && high >= 0.0 ? 0.0 : high;
  const double step = (high - low) / (n - 1);
  const double value = i == n - 1 ? high : low + step * i;
  if (low > 0.0 || high < 0.0 || step == 0.0) return value;
  return i == static_cast<int>(std::lround(-low / step)) ? 0.0 : value;
}

}  // namespace bslnav
