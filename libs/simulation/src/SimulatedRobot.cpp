#include <bslnav/config/Config.h>
#include <bslnav/config/Error.h>
#include <bslnav/simulation/RandomStream.h>
#include <bslnav/simulation/SimulatedRobot.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

constexpr int kPeriods = 20;       // of MRPT's inner loop in one call of advance()
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

void requirePositive(const char* key, double value) {
  if (!(value > 0.0)) Config::refuse("simulated_robot", key, "a number above 0");
}

}  // namespace

void SimulatedRobotParameters::describe(ConfigSection& section) {
  section.number("max_speed_mps", maxSpeed_mps, kPositive, "m/s",
                 "top speed, forward and backward");
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

void SimulatedRobot::Vehicle::advance(double dt_s) {
  // MRPT's loop runs while time <= end, a period too many when asked for whole ones.
  m_firmware_control_period = dt_s / kPeriods;
  simulateOneTimeStep(dt_s - 0.5 * m_firmware_control_period);
}

SimulatedRobot::SimulatedRobot(const SimulatedRobotParameters& parameters,
                               const mrpt::math::TPose2D& start, std::uint64_t seed)
    : parameters_(parameters),
      odometry_(start),
      translationNoise_(randomStream(seed, "odometry/translation")),
      rotationNoise_(randomStream(seed, "odometry/rotation")) {
  requirePositive("max_speed_mps", parameters.maxSpeed_mps);
  requirePositive("max_yaw_rate_degps", parameters.maxYawRate_radps);
  requirePositive("max_acceleration_mps2", parameters.maxAcceleration_mps2);
  requirePositive("max_deceleration_mps2", parameters.maxDeceleration_mps2);
  requirePositive("max_yaw_acceleration_radps2", parameters.maxYawAcceleration_radps2);
  vehicle_.setCurrentGTPose(start);
  vehicle_.setDelayModelParams(parameters.lag_s, 0.0);
}

mrpt::math::TTwist2D SimulatedRobot::delayed(const mrpt::math::TTwist2D& command) {
  queue_.push_back({time_s_ + parameters_.commandLatency_s, command});
  while (!queue_.empty() && queue_.front().due_s <= time_s_ + kTimeSlack_s) {
    active_ = queue_.front().command;
    queue_.erase(queue_.begin());
  }
  return active_;
}

void SimulatedRobot::advance(const mrpt::math::TTwist2D& command, double dt_s) {
  if (!std::isfinite(command.vx) || !std::isfinite(command.omega))
    throw Error("simulated robot", "a command is not a finite number", Error::Kind::Run);
  const auto wanted = delayed(command);
  const double speed = std::clamp(wanted.vx, -parameters_.maxSpeed_mps, parameters_.maxSpeed_mps);
  const double yawRate =
      std::clamp(wanted.omega, -parameters_.maxYawRate_radps, parameters_.maxYawRate_radps);
  const double gain = parameters_.lag_s > 0.0 ? 1.0 - std::exp(-dt_s / parameters_.lag_s) : 1.0;
  const double v = nextSpeed(twist_.vx, speed, gain, parameters_.maxAcceleration_mps2 * dt_s,
                             parameters_.maxDeceleration_mps2 * dt_s);
  const double yawLimit = parameters_.maxYawAcceleration_radps2 * dt_s;
  const double w = nextSpeed(twist_.omega, yawRate, gain, yawLimit, yawLimit);
  // The command whose lag ends at v and w after this step.
  vehicle_.movementCommand(twist_.vx + (v - twist_.vx) / gain,
                           twist_.omega + (w - twist_.omega) / gain);
  const auto before = vehicle_.getCurrentGTPose();
  vehicle_.advance(dt_s);
  vehicle_.setV(v);  // the model sees the lag a period late and would never stand quite still
  vehicle_.setW(w);
  twist_ = {v, 0.0, w};
  time_s_ += dt_s;
  measure(vehicle_.getCurrentGTPose() - before);
}

void SimulatedRobot::measure(const mrpt::math::TPose2D& motion) {
  // Independent steps: variances grow with the motion, whatever the length of a step.
  const double distance_m = std::hypot(motion.x, motion.y);
  const auto squared = [](double value) { return value * value; };
  const double headingVariance =
      squared(parameters_.odometryRotationStd_rad) * std::abs(motion.phi) +
      squared(parameters_.odometryDriftStd_rad) * distance_m;
  auto measured = motion;
  measured.x += translationNoise_.drawGaussian1D(
      0.0, parameters_.odometryTranslationStd_m * std::sqrt(distance_m));
  measured.phi += rotationNoise_.drawGaussian1D(0.0, std::sqrt(headingVariance));
  odometry_ = odometry_ + measured;
}

}  // namespace bslnav
