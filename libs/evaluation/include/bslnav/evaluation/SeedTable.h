#pragma once

#include <bslnav/evaluation/RunTally.h>

#include <string>
#include <vector>

namespace bslnav {

/** The runs of several methods over the same seeds of a scenario. */
struct SeedTable {
  std::string scenario;
  std::vector<RunSummary> runs;  ///< seed by seed, the methods of a seed together

  /** One line a method: runs, goals, contacts, at-fault contacts, mean time to the goal with its 95
   * % interval, clearance. */
  std::string markdown() const;
  /** One row a run. */
  std::string csv() const;
};

}  // namespace bslnav
