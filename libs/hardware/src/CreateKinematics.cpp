#include <bslnav/hardware/CreateKinematics.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

constexpr double kTwistWindow_s = 0.06;  // four frames: a count in one of them is 7 mm/s
constexpr double kTimeSlack_s = 1e-6;

/** Counts from one reading to the next, over the roll-over: the shorter way round. */
int countsBetween(std::uint16_t before, std::uint16_t now) {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(now - before));
}

/** A piece of a circle: `turn_rad` while driving `distance_m`, as it moves a robot at the origin.
 */
mrpt::math::TPose2D arc(double distance_m, double turn_rad) {
  const double half = 0.5 * turn_rad;
  const double chord_m = std::abs(half) < 1e-9 ? distance_m : distance_m * std::sin(half) / half;
  return {chord_m * std::cos(half), chord_m * std::sin(half), turn_rad};
}

}  // namespace

CreateWheels wheelsOf(const mrpt::math::TTwist2D& command, const CreateParameters& parameters) {
  const double apart_mps = 0.5 * parameters.wheelBase_m * command.omega;
  const double left_mps = command.vx - apart_mps, right_mps = command.vx + apart_mps;
  const double faster_mps = std::max(std::abs(left_mps), std::abs(right_mps));
  const double share = std::min(1.0, parameters.maxWheelSpeed_mps / std::max(faster_mps, 1e-9));
  return {share * left_mps, share * right_mps};
}

CreateOdometry::CreateOdometry(const CreateParameters& parameters)
    : metresPerCount_(M_PI * parameters.wheelDiameter_m / parameters.countsPerRevolution),
      wheelBase_m_(parameters.wheelBase_m) {}

void CreateOdometry::add(std::uint16_t leftCounts, std::uint16_t rightCounts, double time_s) {
  if (samples_.empty()) {
    samples_.push_back({time_s, 0.0, 0.0, leftCounts, rightCounts});
    return;
  }
  const Sample& last = samples_.back();
  const double left_m = metresPerCount_ * countsBetween(last.leftCounts, leftCounts);
  const double right_m = metresPerCount_ * countsBetween(last.rightCounts, rightCounts);
  const double distance_m = 0.5 * (left_m + right_m), turn_rad = (right_m - left_m) / wheelBase_m_;
  pose_ = pose_ + arc(distance_m, turn_rad);
  pose_.phi = mrpt::math::wrapToPi(pose_.phi);
  samples_.push_back(
      {time_s, last.distance_m + distance_m, last.turn_rad + turn_rad, leftCounts, rightCounts});
  while (samples_.size() > 2 && time_s - samples_[1].time_s >= kTwistWindow_s - kTimeSlack_s)
    samples_.pop_front();
}

mrpt::math::TTwist2D CreateOdometry::twist() const {
  // Frames that were read in one go have one time: no velocity can be told from them alone.
  if (samples_.empty() || samples_.back().time_s - samples_.front().time_s < 1e-3) return {};
  const Sample &from = samples_.front(), &to = samples_.back();
  const double dt_s = to.time_s - from.time_s;
  return {(to.distance_m - from.distance_m) / dt_s, 0.0, (to.turn_rad - from.turn_rad) / dt_s};
}

}  // namespace bslnav
