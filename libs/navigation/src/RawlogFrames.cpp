#include "RawlogFrames.h"

#include <mrpt/core/Clock.h>

#include <cmath>
#include <utility>

namespace bslnav {
namespace {

using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;
using mrpt::obs::CObservation2DRangeScan;

constexpr std::size_t kMostWaitingScans = 32;  // for odometry that comes late or never

std::optional<double> stampOf(const RawlogFrames::Scans& scans) {
  for (const auto& scan : scans)
    if (scan->timestamp != INVALID_TIMESTAMP) return mrpt::Clock::toDouble(scan->timestamp);
  return std::nullopt;
}

bool isUsable(const CObservation2DRangeScan& scan, std::size_t beam) {
  const float range = scan.getScanRange(beam);
  return scan.getScanRangeValidity(beam) && std::isfinite(range) && range > 0.0f &&
         range < scan.maxRange;
}

}  // namespace

bool RawlogFrames::countOdometry(const TPose2D& pose) {
  const bool usable = std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.phi);
  ++(usable ? statistics.odometryEntries : statistics.droppedOdometry);
  return usable;
}

void RawlogFrames::addIncrement(const TPose2D& increment, const std::optional<TTwist2D>& twist) {
  if (odometry_.hasReading() || !countOdometry(increment)) return;
  release(true);  // an increment leads to what follows it
  odometry_.addIncrement(increment);
  reported_ = twist;
}

void RawlogFrames::addReading(const TPose2D& pose, std::optional<double> stamp_s,
                              const std::optional<TTwist2D>& twist) {
  if (odometry_.hasIncrement() || !countOdometry(pose)) return;
  lastStamp_s_ = stamp_s.value_or(lastStamp_s_);
  if (odometry_.hasReading() && lastStamp_s_ < odometry_.latestStamp_s())
    release(true);  // the clock went back: nothing to interpolate with
  odometry_.addReading(pose, lastStamp_s_);
  reported_ = twist;
  release(false);
}

void RawlogFrames::addScans(Scans scans) {
  lastStamp_s_ = stampOf(scans).value_or(lastStamp_s_);
  waiting_.push_back({statistics.entries - 1, lastStamp_s_, std::move(scans)});
  release(odometry_.hasIncrement());
}

void RawlogFrames::release(bool all) {
  while (!waiting_.empty() &&
         (all || waiting_.size() > kMostWaitingScans ||
          (odometry_.hasReading() && waiting_.front().stamp_s <= odometry_.latestStamp_s()))) {
    emit(waiting_.front());
    waiting_.pop_front();
  }
}

void RawlogFrames::emit(const Waiting& released) {
  SensorFrame frame;
  setTime(frame, released);
  frame.odometry = odometry_.poseAt(released.stamp_s);
  frame.mapFromRobot = frame.odometry;
  if (frame.afterGap) estimator_.restart(frame.odometry, frame.time_s);
  const TTwist2D estimated = estimator_.update(frame.odometry, frame.time_s);
  frame.twist = reported_.value_or(estimated);
  frame.scans.assign(released.scans.begin(), released.scans.end());
  count(frame);
  ready.push_back(std::move(frame));
}

void RawlogFrames::setTime(SensorFrame& frame, const Waiting& released) {
  const auto step = clock_.advance(stampOf(released.scans), released.scans.front()->sensorLabel);
  if (step == RawlogClock::Step::Missing) ++statistics.missingTimeStamps;
  if (step == RawlogClock::Step::None) ++statistics.equalTimeStamps;
  frame.afterGap = step == RawlogClock::Step::Jump;
  if (frame.afterGap) statistics.clockJumps.push_back({released.record, clock_.step_s()});
  frame.time_s = clock_.time_s();
  frame.startTime_s = clock_.startTime_s();
  for (const auto& scan : released.scans)  // so that a scan always has an age
    if (scan->timestamp == INVALID_TIMESTAMP)
      scan->timestamp = mrpt::Clock::fromDouble(frame.startTime_s + frame.time_s);
}

void RawlogFrames::count(const SensorFrame& frame) {
  if (statistics.frames > 0 && !frame.afterGap)
    statistics.pathLength_m +=
        std::hypot(frame.odometry.x - lastOdometry_.x, frame.odometry.y - lastOdometry_.y);
  lastOdometry_ = frame.odometry;
  ++statistics.frames;
  statistics.scans += frame.scans.size();
  statistics.duration_s = frame.time_s;
  statistics.hasOdometry = statistics.odometryEntries > 0;
  for (const auto& scan : frame.scans) {
    statistics.beams += scan->getScanSize();
    for (std::size_t i = 0; i < scan->getScanSize(); ++i)
      if (!isUsable(*scan, i)) ++statistics.unusableBeams;
  }
}

}  // namespace bslnav
