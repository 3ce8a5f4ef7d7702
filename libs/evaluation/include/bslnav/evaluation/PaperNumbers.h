#pragma once

#include <bslnav/evaluation/RunSummary.h>

#include <optional>
#include <string>

namespace bslnav {

/** What the paper reports of one case by one method. */
struct PaperNumbers {
  Outcome outcome = Outcome::Goal;
  std::optional<double> time_s;  ///< to the goal
};

/** The paper's tables for S1 and S2 (simulation), and its statement that Method 4 reached the goal
 * in E1 and E2 (real robot). @param caseName "s1", "s2", "e1" or "e2"; none where it says nothing
 */
std::optional<PaperNumbers> paperNumbers(const std::string& caseName, int method);

/** By how much of the slower time the faster one is shorter [%]; negative when it is longer. */
inline double fasterBy_percent(double faster_s, double slower_s) {
  return 100.0 * (slower_s - faster_s) / slower_s;
}

}  // namespace bslnav
