#pragma once

#include <bslnav/evaluation/Experiment.h>

#include <string>
#include <vector>

namespace bslnav {

/** Runs of several navigators, each with several methods, over the same seeds of several cases. */
struct NavigatorTable {
  struct Row {
    std::string scenario, navigator;
    RunSummary run;
  };
  std::vector<Row> rows;  ///< one a run, in the order of the cases

  /** One line a case, navigator and method: goal rate, contacts, mean time to the goal with its
   * 95 % interval, median of the runs' median cycle times (the only part that differs from run to
   * run). */
  std::string markdown() const;
  /** One row a run. */
  std::string csv() const;
};

}  // namespace bslnav
