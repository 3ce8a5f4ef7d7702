#include <bslnav/evaluation/RunSummary.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

constexpr double kStopped_mps = 0.01;

constexpr double StageTimes::*kStages[] = {&StageTimes::blindSpots_s, &StageTimes::costmap_s,
                                           &StageTimes::people_s,     &StageTimes::globalPlan_s,
                                           &StageTimes::motion_s,     &StageTimes::total_s};

Percentiles percentilesOf(const std::vector<StageTimes>& times, const StageTimes& longest,
                          double StageTimes::*stage) {
  if (times.empty()) return {};
  std::vector<double> values;
  values.reserve(times.size());
  for (const StageTimes& t : times) values.push_back(1e3 * (t.*stage));
  std::sort(values.begin(), values.end());
  const auto at = [&values](double share) {
    return values[static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size()))) -
                  1];
  };
  return {at(0.5), at(0.99), 1e3 * (longest.*stage)};
}

}  // namespace

const char* nameOf(Outcome outcome) {
  static constexpr const char* kNames[] = {"goal", "contact", "timeout", "stuck", "error"};
  return kNames[static_cast<int>(outcome)];
}

std::string measurementsOf(const RawlogFindings& findings) {
  const auto counted = [](long count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
  };
  const std::string scans = counted(findings.scans, "scan");
  const std::string depth = counted(findings.depthFrames, "depth frame");
  if (findings.depthFrames == 0) return scans;
  return findings.scans == 0 ? depth : scans + ", " + depth;
}

void Metrics::add(const CycleRecord& record, const mrpt::math::TPoint2D& position, double speed_mps,
                  double period_s) {
  if (cycles_ > 0) {
    path_m_ += (position - last_).norm();
    time_s_ += period_s;
    if (std::abs(speed_mps) < kStopped_mps) stopped_s_ += period_s;
    if (record.guard.lapse != GuardRecord::Lapse::None) lapse_s_ += period_s;
  }
  last_ = position;
  ++cycles_;
  blocked_ += record.motion.blocked;
  unhealthy_ += record.health != CycleRecord::Health::Ok;
  droppedBeams_ += record.droppedBeams;
  droppedDepthFrames_ += record.droppedDepthFrames;
  // Before the first measurement arrives, all sensors are silent: that is no problem yet.
  const bool started = unhealthy_ < cycles_ || record.droppedDepthFrames > 0;
  if (started && sensorProblem_.empty()) sensorProblem_ = record.sensorProblem;
  goalMoved_ = record.goalMoved;
  blindSpots_ += static_cast<double>(record.blindSpots.size());
  for (const auto stage : kStages) longest_.*stage = std::max(longest_.*stage, record.times.*stage);
  if (thinning_.keepsNext()) times_.push_back(record.times);
  if (thinning_.isFull(times_.size())) Thinning::halve(times_);
}

void Metrics::finish(RunSummary& summary) const {
  summary.cycles = cycles_;
  summary.blockedCycles = blocked_;
  summary.unhealthyCycles = unhealthy_;
  summary.droppedBeams = droppedBeams_;
  summary.droppedDepthFrames = droppedDepthFrames_;
  summary.sensorProblem = sensorProblem_;
  summary.goalMoved = goalMoved_;
  summary.pathLength_m = path_m_;
  summary.meanSpeed_mps = time_s_ > 0.0 ? path_m_ / time_s_ : 0.0;
  summary.timeStopped_s = stopped_s_;
  summary.lapse_s = lapse_s_;
  summary.blindSpotsMean = cycles_ > 0 ? blindSpots_ / cycles_ : 0.0;
  summary.cycle_ms = percentilesOf(times_, longest_, &StageTimes::total_s);
  summary.blindSpots_ms = percentilesOf(times_, longest_, &StageTimes::blindSpots_s);
  summary.costmap_ms = percentilesOf(times_, longest_, &StageTimes::costmap_s);
  summary.people_ms = percentilesOf(times_, longest_, &StageTimes::people_s);
  summary.globalPlan_ms = percentilesOf(times_, longest_, &StageTimes::globalPlan_s);
  summary.motion_ms = percentilesOf(times_, longest_, &StageTimes::motion_s);
}

}  // namespace bslnav
