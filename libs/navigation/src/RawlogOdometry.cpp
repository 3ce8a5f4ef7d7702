#include "RawlogOdometry.h"

#include <mrpt/math/wrap2pi.h>

#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;

constexpr double kSmoothingTime_s =
    0.1;  // half a period of the usual 5 Hz logs: takes the jitter of the stamps off

/** The constant twist that moves the robot by `increment` in `duration_s`: the logarithm of SE(2).
 */
TTwist2D constantTwist(const TPose2D& increment, double duration_s) {
  const double half = increment.phi / 2.0;
  const double cotangent = std::abs(half) < 1e-6 ? 1.0 : half / std::tan(half);
  return {(cotangent * increment.x + half * increment.y) / duration_s,
          (cotangent * increment.y - half * increment.x) / duration_s, increment.phi / duration_s};
}

}  // namespace

void RawlogOdometry::addIncrement(const TPose2D& increment) {
  latest_.pose = latest_.pose + increment;
  source_ = Source::Increments;
}

void RawlogOdometry::addReading(const TPose2D& pose, double stamp_s) {
  const bool continues = hasReading() && stamp_s >= latest_.stamp_s;
  before_ = continues ? latest_ : Reading{stamp_s, pose};
  latest_ = {stamp_s, pose};
  source_ = Source::Readings;
}

TPose2D RawlogOdometry::poseAt(double stamp_s) const {
  if (!hasReading() || stamp_s >= latest_.stamp_s) return latest_.pose;
  if (stamp_s <= before_.stamp_s) return before_.pose;
  const double part = (stamp_s - before_.stamp_s) / (latest_.stamp_s - before_.stamp_s);
  const TPose2D &a = before_.pose, &b = latest_.pose;
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y),
          mrpt::math::wrapToPi(a.phi + part * mrpt::math::wrapToPi(b.phi - a.phi))};
}

void TwistEstimator::restart(const TPose2D& pose, double time_s) {
  pose_ = pose;
  time_s_ = time_s;
  twist_ = {};
  hasPose_ = true;
  hasTwist_ = false;
}

TTwist2D TwistEstimator::update(const TPose2D& pose, double time_s) {
  if (!hasPose_) restart(pose, time_s);
  const double duration_s = time_s - time_s_;
  if (duration_s <= 0.0) return twist_;
  const TTwist2D measured = constantTwist(pose - pose_, duration_s);
  const double weight = hasTwist_ ? duration_s / (duration_s + kSmoothingTime_s) : 1.0;
  twist_.vx += weight * (measured.vx - twist_.vx);
  twist_.vy += weight * (measured.vy - twist_.vy);
  twist_.omega += weight * (measured.omega - twist_.omega);
  pose_ = pose;
  time_s_ = time_s;
  hasTwist_ = true;
  return twist_;
}

}  // namespace bslnav
