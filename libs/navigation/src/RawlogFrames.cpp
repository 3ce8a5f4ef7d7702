#include "RawlogFrames.h"

#include <mrpt/core/Clock.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "RawlogDepth.h"

namespace bslnav {
namespace {

using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;
using mrpt::obs::CObservation2DRangeScan;

constexpr double kTicksPerSecond = 1e7;   // of MRPT's clock
constexpr std::size_t kMostWaiting = 32;  // records, for odometry that comes late or never

/** All of them, scans first. */
std::vector<mrpt::obs::CObservation*> observationsOf(const RawlogMeasurements& measurements) {
  std::vector<mrpt::obs::CObservation*> all;
  for (const auto& scan : measurements.scans) all.push_back(scan.get());
  for (const auto& depth : measurements.depth) all.push_back(depth.get());
  return all;
}

std::optional<double> stampOf(const std::vector<mrpt::obs::CObservation*>& observations) {
  for (const auto* observation : observations)
    if (observation->timestamp != INVALID_TIMESTAMP)
      return mrpt::Clock::toDouble(observation->timestamp);
  return std::nullopt;
}

/** A laser and a camera may share a label, often the empty one. */
std::string nameOfSensor(const mrpt::obs::CObservation& observation) {
  return observation.GetRuntimeClass()->className + (" " + observation.sensorLabel);
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

void RawlogFrames::addMeasurements(RawlogMeasurements measurements) {
  if (measurements.empty()) return;
  for (const auto& depth : measurements.depth) forgetPoints(*depth);
  lastStamp_s_ = stampOf(observationsOf(measurements)).value_or(lastStamp_s_);
  if (framing_ == RawlogFraming::RecordedPoses) {
    auto& [scans, depth] = cycle_;
    scans.insert(scans.end(), measurements.scans.begin(), measurements.scans.end());
    depth.insert(depth.end(), measurements.depth.begin(), measurements.depth.end());
    return;
  }
  waiting_.push_back({statistics.entries - 1, lastStamp_s_, std::move(measurements)});
  release(odometry_.hasIncrement());
}

void RawlogFrames::release(bool all) {
  while (!waiting_.empty() &&
         (all || waiting_.size() > kMostWaiting ||
          (odometry_.hasReading() && waiting_.front().stamp_s <= odometry_.latestStamp_s()))) {
    dropDepthWithoutImage(waiting_.front());
    if (!waiting_.front().measurements.empty()) emit(waiting_.front());
    waiting_.pop_front();
  }
}

void RawlogFrames::dropDepthWithoutImage(Waiting& released) {
  auto& depth = released.measurements.depth;
  const auto isUnusable = [&](const auto& observation) {
    const std::string problem = loadRangeImage(*observation, imagesDirectory_);
    if (problem.empty()) return false;
    if (statistics.droppedDepthFrames++ == 0)
      statistics.firstDroppedDepth = "record " + std::to_string(released.record) + ": " + problem;
    return true;
  };
  depth.erase(std::remove_if(depth.begin(), depth.end(), isUnusable), depth.end());
}

void RawlogFrames::emit(const Waiting& released) {
  SensorFrame frame;
  const auto observations = observationsOf(released.measurements);
  setTime(frame, released,
          clock_.advance(stampOf(observations), nameOfSensor(*observations.front())));
  complete(frame, released);
  frame.mapFromRobot = frame.odometry;
  ready.push_back(std::move(frame));
}

/* Seconds since the epoch have steps of 0.1 us as a double, and their sums far more; the difference
 * of two stamps is exact. */
void RawlogFrames::addPose(const TPose2D& mapFromRobot, mrpt::Clock::time_point stamp) {
  if (framing_ != RawlogFraming::RecordedPoses) return;
  if (!origin_) origin_ = stamp;
  const double sinceOrigin_s = static_cast<double>((stamp - *origin_).count()) / kTicksPerSecond;
  Waiting cycle{statistics.entries - 1, mrpt::Clock::toDouble(stamp), std::exchange(cycle_, {})};
  dropDepthWithoutImage(cycle);
  SensorFrame frame;
  setTime(frame, cycle, clock_.advance(sinceOrigin_s, "pose"));
  frame.startTime_s += mrpt::Clock::toDouble(*origin_);
  complete(frame, cycle);
  frame.mapFromRobot = mapFromRobot;
  ready.push_back(std::move(frame));
}

void RawlogFrames::setTime(SensorFrame& frame, const Waiting& released, RawlogClock::Step step) {
  if (step == RawlogClock::Step::Missing) ++statistics.missingTimeStamps;
  if (step == RawlogClock::Step::None) ++statistics.equalTimeStamps;
  frame.afterGap = step == RawlogClock::Step::Jump;
  if (frame.afterGap) statistics.clockJumps.push_back({released.record, clock_.step_s()});
  frame.time_s = clock_.time_s();
  frame.startTime_s = clock_.startTime_s();
}

/** Everything that comes after its time. */
void RawlogFrames::complete(SensorFrame& frame, const Waiting& released) {
  for (auto* observation :
       observationsOf(released.measurements))  // so that all of them have an age
    if (observation->timestamp == INVALID_TIMESTAMP)
      observation->timestamp = mrpt::Clock::fromDouble(frame.startTime_s + frame.time_s);
  frame.odometry = odometry_.poseAt(released.stamp_s);
  if (frame.afterGap) estimator_.restart(frame.odometry, frame.time_s);
  const TTwist2D estimated = estimator_.update(frame.odometry, frame.time_s);
  frame.twist = reported_.value_or(estimated);
  frame.scans.assign(released.measurements.scans.begin(), released.measurements.scans.end());
  frame.depth.assign(released.measurements.depth.begin(), released.measurements.depth.end());
  count(frame);
}

void RawlogFrames::count(const SensorFrame& frame) {
  if (statistics.frames > 0 && !frame.afterGap)
    statistics.pathLength_m +=
        std::hypot(frame.odometry.x - lastOdometry_.x, frame.odometry.y - lastOdometry_.y);
  lastOdometry_ = frame.odometry;
  ++statistics.frames;
  statistics.scans += frame.scans.size();
  statistics.depthFrames += frame.depth.size();
  statistics.duration_s = frame.time_s;
  statistics.hasOdometry = statistics.odometryEntries > 0;
  for (const auto& scan : frame.scans) {
    statistics.beams += scan->getScanSize();
    for (std::size_t i = 0; i < scan->getScanSize(); ++i)
      if (!isUsable(*scan, i)) ++statistics.unusableBeams;
  }
}

}  // namespace bslnav
