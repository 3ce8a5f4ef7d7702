#include <bslnav/planning/DynamicWindow.h>

#include <cmath>

namespace bslnav {

DynamicWindow dynamicWindow(const mrpt::math::TTwist2D& current, const RobotLimits& limits,
                            double window_s, double speedCap_mps) {
  const double turn = limits.maxYawRate_radps;
  const auto low = limited({0.0, 0.0, -turn}, current, limits, window_s);
  const auto high = limited({speedCap_mps, 0.0, turn}, current, limits, window_s);
  return {low.vx, high.vx, low.omega, high.omega};
}

double sampleOf(double low, double high, int i, int n) {
  if (n == 1) return low <= 0.0 && high >= 0.0 ? 0.0 : high;
  const double step = (high - low) / (n - 1);
  const double value = i == n - 1 ? high : low + step * i;
  if (low > 0.0 || high < 0.0 || step == 0.0) return value;
  return i == static_cast<int>(std::lround(-low / step)) ? 0.0 : value;
}

}  // namespace bslnav
