#pragma once

#include <bslnav/evaluation/CycleSnapshots.h>
#include <bslnav/evaluation/RawlogRun.h>
#include <bslnav/evaluation/RunSummary.h>
#include <bslnav/planning/Guard.h>

#include <memory>
#include <vector>

namespace bslnav {

/** What the guard makes of a recorded drive: frontiers beside the raw jumps of its scans, and how
 * often the robot was faster than the guard would have let it be.
 *
 * A jump is plausible when hidden people's frontier lies behind it, along its ray. */
class GuardAudit {
 public:
  /** @param map as the log's cycles have it, or null */
  GuardAudit(const NavigationParameters& parameters,
             const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map);

  /** Takes in a cycle of an evaluation with the guard; others say nothing. */
  void observe(const RawlogMoment& moment);

  /** Of all cycles so far. */
  const GuardFindings& findings() const { return sums_; }
  /** The moments at which the robot was faster than its bound by most, each of another 5 s of the
   * log, in the order of time; what binds is in their records. At most three. */
  const std::vector<CycleSnapshot>& worst() const { return worst_; }

 private:
  void countJumps(const RawlogMoment& moment);
  void judgeSpeed(const RawlogMoment& moment);
  void keepWorst(double excess_mps, const CycleSnapshot& snapshot);

  NavigationParameters parameters_;
  std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> map_;
  ScanJumpDetector jumps_;
  Guard guard_;
  GuardFindings sums_;
  std::vector<double> excess_mps_;  // of worst_
  std::vector<CycleSnapshot> worst_;
};

}  // namespace bslnav
