#include <bslnav/config/Config.h>
#include <bslnav/config/Error.h>
#include <bslnav/simulation/RandomStream.h>
#include <bslnav/simulation/SimulatedRobot.h>
#include <mrpt/math/TPoint2D.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TTwist2D;

constexpr double kSettled = 1e-6;  // speeds that differ by less are equal [m/s, rad/s]
constexpr double kTimeSlack_s = 1e-9;

/** One step of the lag towards `wanted` within the limits; stops at 0 before it turns round. */
double nextSpeed(double now, double wanted, double gain, double speedUp, double slowDown) {
  if (std::abs(wanted - now) < kSettled) return wanted;
  const double change = (wanted - now) * gain;
  const double limit = now * change < 0.0 ? slowDown : speedUp;
  const double next = now + std::clamp(change, -limit, limit);
  return now * next < 0.0 ? 0.0 : next;
}

/** The same for a velocity (vx, vy), straight towards `wanted`; what slows down ends where that way
 * is nearest to standstill. */
TPoint2D nextVelocity(const TPoint2D& now, const TPoint2D& wanted, double gain, double speedUp,
                      double slowDown) {
  const TPoint2D way = wanted - now;
  const double whole = way.norm();
  if (whole < kSettled) return wanted;
  const double slowing = -(now.x * way.x + now.y * way.y) / whole;
  const double limit = slowing > kSettled ? std::min(slowDown, slowing) : speedUp;
  return now + way * (std::min(whole * gain, limit) / whole);
}

/** A command within the top speed, in its direction. */
TPoint2D withinSpeed(const TPoint2D& velocity, double maxSpeed_mps) {
  const double speed = velocity.norm();
  return speed > maxSpeed_mps ? velocity * (maxSpeed_mps / speed) : velocity;
}

void requirePositive(const char* key, double value) {
  if (!(value > 0.0)) Config::refuse("simulated_robot", key, "a number above 0");
}

}  // namespace

void SimulatedRobotParameters::describe(ConfigSection& section) {
  section.choice(
      "kinematics", kinematics,
      {{"diff_drive", BaseKinematics::DiffDrive}, {"holonomic", BaseKinematics::Holonomic}},
      "what the base can drive: forward and turns, or sideways, too");
  section.number("max_speed_mps", maxSpeed_mps, kPositive, "m/s",
                 "top speed, forward and backward; holonomic: in every direction");
  section.angle("max_yaw_rate_degps", maxYawRate_radps, kPositive, "fastest turn");
  section.number("max_acceleration_mps2", maxAcceleration_mps2, kPositive, "m/s²",
                 "limit of speeding up");
  section.number("max_deceleration_mps2", maxDeceleration_mps2, kPositive, "m/s²",
                 "limit of slowing down");
  section.number("max_yaw_acceleration_radps2", maxYawAcceleration_radps2, kPositive, "rad/s²",
                 "limit of changing the yaw rate");
  section.number("lag_s", lag_s, kNonNegative, "s",
                 "time constant with which speeds follow commands");
  section.number("command_latency_s", commandLatency_s, {0.0, 10.0}, "s",
                 "from a command to its first effect");
  section.number("odometry_translation_std_m", odometryTranslationStd_m, kNonNegative, "m",
                 "standard deviation of the distance after 1 m; grows with the square root");
  section.angle(
      "odometry_rotation_std_deg", odometryRotationStd_rad, kNonNegative,
      "standard deviation of the heading after a turn of 1 rad; grows with the square root");
  section.angle("odometry_drift_std_deg", odometryDriftStd_rad, kNonNegative,
                "standard deviation of the heading after 1 m; grows with the square root");
}

SimulatedRobot::SimulatedRobot(const SimulatedRobotParameters& parameters,
                               const mrpt::math::TPose2D& start, std::uint64_t seed)
    : parameters_(parameters),
      base_(makeSimulatedBase(parameters.kinematics, start, parameters.lag_s)),
      odometry_(start),
      translationNoise_(randomStream(seed, "odometry/translation")),
      rotationNoise_(randomStream(seed, "odometry/rotation")) {
  requirePositive("max_speed_mps", parameters.maxSpeed_mps);
  requirePositive("max_yaw_rate_degps", parameters.maxYawRate_radps);
  requirePositive("max_acceleration_mps2", parameters.maxAcceleration_mps2);
  requirePositive("max_deceleration_mps2", parameters.maxDeceleration_mps2);
  requirePositive("max_yaw_acceleration_radps2", parameters.maxYawAcceleration_radps2);
}

TTwist2D SimulatedRobot::delayed(const TTwist2D& command) {
  queue_.push_back({time_s_ + parameters_.commandLatency_s, command});
  while (!queue_.empty() && queue_.front().due_s <= time_s_ + kTimeSlack_s) {
    active_ = queue_.front().command;
    queue_.erase(queue_.begin());
  }
  return active_;
}

TTwist2D SimulatedRobot::reached(const TTwist2D& wanted, double gain, double dt_s) const {
  const SimulatedRobotParameters& p = parameters_;
  const double yawRate = std::clamp(wanted.omega, -p.maxYawRate_radps, p.maxYawRate_radps);
  const double yawLimit = p.maxYawAcceleration_radps2 * dt_s;
  const double w = nextSpeed(twist_.omega, yawRate, gain, yawLimit, yawLimit);
  const double speedUp = p.maxAcceleration_mps2 * dt_s, slowDown = p.maxDeceleration_mps2 * dt_s;
  if (isHolonomic()) {
    const TPoint2D v =
        nextVelocity({twist_.vx, twist_.vy}, withinSpeed({wanted.vx, wanted.vy}, p.maxSpeed_mps),
                     gain, speedUp, slowDown);
    return {v.x, v.y, w};
  }
  const double speed = std::clamp(wanted.vx, -p.maxSpeed_mps, p.maxSpeed_mps);
  return {nextSpeed(twist_.vx, speed, gain, speedUp, slowDown), 0.0, w};
}

void SimulatedRobot::advance(const TTwist2D& command, double dt_s) {
  if (!std::isfinite(command.vx) || !std::isfinite(command.omega) ||
      (isHolonomic() && !std::isfinite(command.vy)))
    throw Error("simulated robot", "a command is not a finite number", Error::Kind::Run);
  const double gain = parameters_.lag_s > 0.0 ? 1.0 - std::exp(-dt_s / parameters_.lag_s) : 1.0;
  const TTwist2D next = reached(delayed(command), gain, dt_s);
  const auto before = pose();
  base_->move(twist_, next, gain, dt_s);
  twist_ = next;
  time_s_ += dt_s;
  measure(pose() - before);
}

void SimulatedRobot::measure(const mrpt::math::TPose2D& motion) {
  // Independent steps: variances grow with the motion, whatever the length of a step.
  const double distance_m = std::hypot(motion.x, motion.y);
  const auto squared = [](double value) { return value * value; };
  const double headingVariance =
      squared(parameters_.odometryRotationStd_rad) * std::abs(motion.phi) +
      squared(parameters_.odometryDriftStd_rad) * distance_m;
  auto measured = motion;
  const double error_m = translationNoise_.drawGaussian1D(
      0.0, parameters_.odometryTranslationStd_m * std::sqrt(distance_m));
  if (!isHolonomic()) {
    measured.x += error_m;
  } else if (distance_m > 0.0) {  // along the way, wherever that leads
    measured.x += error_m * motion.x / distance_m;
    measured.y += error_m * motion.y / distance_m;
  }
  measured.phi += rotationNoise_.drawGaussian1D(0.0, std::sqrt(headingVariance));
  odometry_ = odometry_ + measured;
}

}  // namespace bslnav
