#include <bslnav/evaluation/RunTally.h>

#include <algorithm>
#include <cmath>

namespace bslnav {

void RunTally::add(const RunSummary& run) {
  ++runs;
  goals += run.outcome == Outcome::Goal;
  contacts += run.contact;
  atFault += run.atFault;
  other += run.outcome != Outcome::Goal && run.outcome != Outcome::Contact;
  if (run.timeToGoal_s) times_s.push_back(*run.timeToGoal_s);
  // in contact it may come out a little negative, by what was driven in one step of the simulator
  if (run.minClearance_m) clearance_m.push_back(std::max(0.0, *run.minClearance_m));
}

RunTally tallyOf(const std::vector<RunSummary>& runs) {
  RunTally tally;
  for (const RunSummary& run : runs) tally.add(run);
  return tally;
}

MeanInterval meanInterval(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  if (values.empty()) return {};
  double sum = 0.0, squares = 0.0;
  for (const double v : values) sum += v;
  const double mean = sum / n;
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {mean, n > 1 ? 1.96 * std::sqrt(squares / (n - 1) / n) : 0.0};
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace bslnav
