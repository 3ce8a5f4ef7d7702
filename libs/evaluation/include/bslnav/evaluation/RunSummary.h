#pragma once

#include <bslnav/evaluation/Thinning.h>
#include <bslnav/navigation/CycleRecord.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace bslnav {

/** How a run ended. */
enum class Outcome : std::uint8_t { Goal, Contact, Timeout, Stuck, Error };
/** The word for an outcome in summary.json and in tables. */
const char* nameOf(Outcome outcome);

/** Median, 99th percentile and maximum of a stage over all cycles [ms]; the former two over those
 * that are kept of a long run. */
struct Percentiles {
  double p50 = 0.0, p99 = 0.0, max = 0.0;
};

/** What the guard makes of a recorded drive; sums over its cycles. */
struct GuardFindings {
  long scans = 0, frontiers = 0;  ///< frontiers: connected pieces, of hidden people
  long jumps = 0;                 ///< neighbouring beams whose ranges differ by Z_th
  long plausible = 0;             ///< jumps behind which somebody may be
  long tooFar = 0;                ///< jumps beyond [hidden_people] reach_m
  long nobodyFits = 0;            ///< jumps behind which no person fits
  long seenEmpty = 0;             ///< jumps whose shadow was seen empty too short a time ago
  long drivingCycles = 0;         ///< in which the robot was faster than 0.05 m/s
  long exceededCycles = 0;        ///< of these, faster than the guard's bound
  double mostExceeded_mps = 0.0;
};

/** What only an offline evaluation tells: about the log, and the planner beside the recording. */
struct RawlogFindings {
  std::string log;
  long records = 0, frames = 0;
  long scans = 0, depthFrames = 0;
  long droppedDepthFrames = 0;    ///< without a range image
  std::string firstDroppedDepth;  ///< record, file and problem
  double recorded_s = 0.0, recordedPath_m = 0.0;
  double unusableBeams_percent = 0.0;
  bool hasOdometry = true;
  std::optional<long> truncatedAtRecord;
  std::vector<long> clockJumpsAtRecords;
  double meanSpread_m = 0.0;             ///< of the localisation
  double speedDifferenceMean_mps = 0.0;  ///< mean |chosen by the planner − recorded|
  double yawRateDifferenceMean_radps = 0.0;
  double slowerThanRecorded_percent =
      0.0;                             ///< cycles in which the planner was at least 0.1 m/s slower
  double wall_s = 0.0;                 ///< wall-clock time of localisation and control cycles
  std::optional<GuardFindings> guard;  ///< with the guard
};

/** The measurements of a log in words: "37 scans, 12 depth frames". */
std::string measurementsOf(const RawlogFindings& findings);

/** What a run came to; everything but the timings is the same in every repetition. */
struct RunSummary {
  Outcome outcome = Outcome::Error;
  std::string reason;  ///< why, when it is not the goal
  std::optional<double> timeToGoal_s;
  double duration_s = 0.0;  ///< simulated or recorded time
  double pathLength_m = 0.0, meanSpeed_mps = 0.0, timeStopped_s = 0.0;
  bool contact = false,
       atFault = false;  ///< at fault: the robot was faster than 0.05 m/s at contact
  std::optional<double> impactSpeed_mps;  ///< of the robot at contact
  std::optional<double> minClearance_m;   ///< to people; none without people
  bool goalMoved = false;       ///< it was blocked: the robot drove to the nearest reachable place
  double blindSpotsMean = 0.0;  ///< per cycle
  int cycles = 0, blockedCycles = 0, unhealthyCycles = 0;
  double lapse_s = 0.0;  ///< time in which the robot moved and the guard's promise did not hold
  long droppedBeams = 0, droppedDepthFrames = 0;
  std::string sensorProblem;  ///< the first one, in words; empty for none
  Percentiles cycle_ms, blindSpots_ms, costmap_ms, people_ms, globalPlan_ms, motion_ms;
  int method = 0;
  std::string methodName;
  std::uint64_t seed = 0;
  std::optional<RawlogFindings> rawlog;
};

/** Adds up the records of a run. */
class Metrics {
 public:
  /** @param position,speed_mps where the robot truly is and how fast it moves
   *  @param period_s time since the cycle before; that of the first does not count */
  void add(const CycleRecord& record, const mrpt::math::TPoint2D& position, double speed_mps,
           double period_s);

  /** Fills in everything that comes from the records. */
  void finish(RunSummary& summary) const;

 private:
  int cycles_ = 0, blocked_ = 0, unhealthy_ = 0;
  long droppedBeams_ = 0, droppedDepthFrames_ = 0;
  std::string sensorProblem_;
  bool goalMoved_ = false;
  double path_m_ = 0.0, lapse_s_ = 0.0, stopped_s_ = 0.0, time_s_ = 0.0, blindSpots_ = 0.0;
  mrpt::math::TPoint2D last_;
  Thinning thinning_;
  std::vector<StageTimes> times_;
  StageTimes longest_;
};

}  // namespace bslnav
