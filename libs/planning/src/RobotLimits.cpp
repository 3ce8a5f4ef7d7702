#include <bslnav/planning/RobotLimits.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

/** Lowest value one period after `current`: it changes by `fall` towards zero and, in the time that
 * is left when zero is reached, by `rise` away from it. */
double lowest(double current, double rise, double fall) {
  if (current <= 0.0) return current - rise;
  return current >= fall ? current - fall : -rise * (1.0 - current / fall);
}

/** `wanted`, moved to what can be reached from `current`: away from zero by `rise`, towards it by
 * `fall`. */
double reachable(double wanted, double current, double rise, double fall) {
  return std::clamp(wanted, lowest(current, rise, fall), -lowest(-current, rise, fall));
}

}  // namespace

void RobotLimits::describe(ConfigSection& section) {
  section.number("max_speed_mps", maxSpeed_mps, {0.01, 10.0}, "m/s", "highest forward speed");
  section.angle("max_yaw_rate_degps", maxYawRate_radps, {1.0, 720.0}, "highest turning rate");
  section.number("acceleration_mps2", acceleration_mps2, {0.01, 20.0}, "m/s^2",
                 "highest increase of speed");
  section.number("deceleration_mps2", deceleration_mps2, {0.01, 20.0}, "m/s^2",
                 "highest decrease of speed");
  section.angle("yaw_acceleration_degps2", yawAcceleration_radps2, {1.0, 7200.0},
                "highest change of the turning rate");
  section.number("response_s", response_s, {0.0, 5.0}, "s",
                 "how far the measured velocity may trail the commanded one (lag and latency)");
}

mrpt::math::TTwist2D commandBase(const mrpt::math::TTwist2D& measured,
                                 const mrpt::math::TTwist2D& lastCommand,
                                 const RobotLimits& limits) {
  const double v = limits.response_s * std::max(limits.acceleration_mps2, limits.deceleration_mps2);
  const double w = limits.response_s * limits.yawAcceleration_radps2;
  return {std::clamp(lastCommand.vx, measured.vx - v, measured.vx + v), 0.0,
          std::clamp(lastCommand.omega, measured.omega - w, measured.omega + w)};
}

mrpt::math::TTwist2D limited(const mrpt::math::TTwist2D& wanted,
                             const mrpt::math::TTwist2D& current, const RobotLimits& limits,
                             double period_s) {
  const double rise = limits.acceleration_mps2 * period_s,
               fall = limits.deceleration_mps2 * period_s;
  const double turn = limits.yawAcceleration_radps2 * period_s;
  const double v = std::clamp(wanted.vx, -limits.maxSpeed_mps, limits.maxSpeed_mps);
  const double w = std::clamp(wanted.omega, -limits.maxYawRate_radps, limits.maxYawRate_radps);
  return {reachable(v, current.vx, rise, fall), 0.0, reachable(w, current.omega, turn, turn)};
}

mrpt::math::TTwist2D brake(const mrpt::math::TTwist2D& current, const RobotLimits& limits,
                           double period_s) {
  return limited({0.0, 0.0, 0.0}, current, limits, period_s);
}

double stoppingSpeed(double distance, double deceleration, double period_s) {
  // n periods at v, v − aT, v − 2aT, ... cover v²/2a + vT/2; less than one period covers vT.
  const double half = 0.5 * deceleration * period_s;
  return std::min(std::sqrt(half * half + 2.0 * deceleration * distance) - half,
                  distance / period_s);
}

}  // namespace bslnav
