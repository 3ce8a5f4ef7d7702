#include <bslnav/planning/RobotLimits.h>
#include <mrpt/math/TPoint2D.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TTwist2D;

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

/** `wanted`, or how far towards it one comes from `current` on a straight line: slowing down by
 * `fall` to where the line is nearest to zero, and then by `rise` in the time that is left. */
TPoint2D reachable(const TPoint2D& wanted, const TPoint2D& current, double rise, double fall) {
  const TPoint2D way = wanted - current;
  const double whole = way.norm();
  if (whole == 0.0) return wanted;
  const double slowing = std::max(0.0, -(current.x * way.x + current.y * way.y) / whole);
  const double far = slowing >= fall ? fall : slowing + rise * (1.0 - slowing / fall);
  return far >= whole ? wanted : current + way * (far / whole);
}

TPoint2D shortened(const TPoint2D& vector, double longest) {
  const double length = vector.norm();
  return length > longest ? vector * (longest / length) : vector;
}

/** Whether there is lateral motion to think of: without it, all is as for a differential drive. */
bool isLateral(const TTwist2D& a, const TTwist2D& b, const RobotLimits& limits) {
  return limits.maxLateralSpeed_mps > 0.0 && (a.vy != 0.0 || b.vy != 0.0);
}

}  // namespace

void RobotLimits::describe(ConfigSection& section) {
  section.number("max_speed_mps", maxSpeed_mps, {0.01, 10.0}, "m/s",
                 "highest forward speed; with lateral motion, of the vector (vx, vy)");
  section.angle("max_yaw_rate_degps", maxYawRate_radps, {1.0, 720.0}, "highest turning rate");
  section.number("acceleration_mps2", acceleration_mps2, {0.01, 20.0}, "m/s^2",
                 "highest increase of speed");
  section.number("deceleration_mps2", deceleration_mps2, {0.01, 20.0}, "m/s^2",
                 "highest decrease of speed");
  section.angle("yaw_acceleration_degps2", yawAcceleration_radps2, {1.0, 7200.0},
                "highest change of the turning rate");
  section.number("response_s", response_s, {0.0, 5.0}, "s",
                 "how far the measured velocity may trail the commanded one (lag and latency)");
  section.number("max_lateral_speed_mps", maxLateralSpeed_mps, {0.0, 10.0}, "m/s",
                 "highest speed to either side; 0: the robot cannot move sideways");
}

TTwist2D commandBase(const TTwist2D& measured, const TTwist2D& lastCommand,
                     const RobotLimits& limits) {
  const double v = limits.response_s * std::max(limits.acceleration_mps2, limits.deceleration_mps2);
  const double w = limits.response_s * limits.yawAcceleration_radps2;
  const double omega = std::clamp(lastCommand.omega, measured.omega - w, measured.omega + w);
  if (isLateral(measured, lastCommand, limits)) {
    const TPoint2D now{measured.vx, measured.vy}, last{lastCommand.vx, lastCommand.vy};
    const TPoint2D base = now + shortened(last - now, v);
    return {base.x, base.y, omega};
  }
  return {std::clamp(lastCommand.vx, measured.vx - v, measured.vx + v), 0.0, omega};
}

TTwist2D limited(const TTwist2D& wanted, const TTwist2D& current, const RobotLimits& limits,
                 double period_s) {
  const double rise = limits.acceleration_mps2 * period_s,
               fall = limits.deceleration_mps2 * period_s;
  const double turn = limits.yawAcceleration_radps2 * period_s;
  const double w = std::clamp(wanted.omega, -limits.maxYawRate_radps, limits.maxYawRate_radps);
  const double omega = reachable(w, current.omega, turn, turn);
  if (isLateral(wanted, current, limits)) {
    const double side = limits.maxLateralSpeed_mps;
    const TPoint2D aim =
        shortened({wanted.vx, std::clamp(wanted.vy, -side, side)}, limits.maxSpeed_mps);
    const TPoint2D next = reachable(aim, TPoint2D{current.vx, current.vy}, rise, fall);
    return {next.x, next.y, omega};
  }
  const double v = std::clamp(wanted.vx, -limits.maxSpeed_mps, limits.maxSpeed_mps);
  return {reachable(v, current.vx, rise, fall), 0.0, omega};
}

TTwist2D brake(const TTwist2D& current, const RobotLimits& limits, double period_s) {
  return limited({0.0, 0.0, 0.0}, current, limits, period_s);
}

double speedOf(const TTwist2D& twist) {
  return twist.vy == 0.0 ? twist.vx : std::hypot(twist.vx, twist.vy);
}

double speedOf(const TTwist2D& measured, const RobotLimits& limits) {
  return limits.maxLateralSpeed_mps > 0.0 ? speedOf(measured) : measured.vx;
}

double stoppingSpeed(double distance, double deceleration, double period_s) {
  // n periods at v, v − aT, v − 2aT, ... cover v²/2a + vT/2; less than one period covers vT.
  const double half = 0.5 * deceleration * period_s;
  return std::min(std::sqrt(half * half + 2.0 * deceleration * distance) - half,
                  distance / period_s);
}

}  // namespace bslnav
