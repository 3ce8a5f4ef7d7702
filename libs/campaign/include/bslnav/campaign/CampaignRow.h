#pragma once

#include <bslnav/evaluation/RunSummary.h>

#include <optional>
#include <string>
#include <vector>

namespace bslnav {

/** How one entrant did in one encounter: a row of results.csv. */
struct CampaignRow {
  long encounter = 0;
  std::string family;
  std::uint64_t seed = 0;
  int method = 0;
  std::string engine, sensors;
  std::string outcome;  ///< goal, contact, timeout, stuck or error
  bool contact = false, atFault = false;
  std::optional<double> impactSpeed_mps, minClearance_m, timeToGoal_s;
  std::optional<double>
      timeEmpty_s;  ///< to the goal with nobody there; none: not driven or not there
  /** The least time that a pass of this opening takes with nobody there, standing before whoever
   * steps out: fastestPass_s(); none: of another family, or not driven with nobody there. */
  std::optional<double> yardstick_s;
  double pathLength_m = 0.0, timeStopped_s = 0.0;
  double lapse_s = 0.0;  ///< time in which the guard's promise did not hold

  /** Takes over what a run came to. */
  void take(const RunSummary& run);
  /** As one line of CSV, without its end. */
  std::string csv() const;
  /** @throws Error (Run) naming `where` and what was expected */
  static CampaignRow fromCsv(const std::string& line, const std::string& where);
  /** The header of the CSV. */
  static std::string csvHeader();
};

}  // namespace bslnav
