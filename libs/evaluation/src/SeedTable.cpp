#include <bslnav/evaluation/SeedTable.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace bslnav {
namespace {

std::string text(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

/** A CSV field that may hold anything. */
std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\n") == std::string::npos) return field;
  std::string quotes = "\"";
  for (const char c : field) quotes += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quotes + "\"";
}

/** What the runs of one method add up to. */
struct Tally {
  std::string name;
  int runs = 0, goals = 0, contacts = 0, atFault = 0, other = 0;
  std::vector<double> times_s;
  double minClearance_m = std::numeric_limits<double>::infinity();

  void add(const RunSummary& run) {
    name = run.methodName;
    ++runs;
    goals += run.outcome == Outcome::Goal;
    contacts += run.contact;
    atFault += run.atFault;
    other += run.outcome != Outcome::Goal && run.outcome != Outcome::Contact;
    if (run.timeToGoal_s) times_s.push_back(*run.timeToGoal_s);
    if (run.minClearance_m) minClearance_m = std::min(minClearance_m, *run.minClearance_m);
  }
};

}  // namespace

MeanInterval meanInterval(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  if (values.empty()) return {};
  double sum = 0.0, squares = 0.0;
  for (const double v : values) sum += v;
  const double mean = sum / n;
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {mean, n > 1 ? 1.96 * std::sqrt(squares / (n - 1) / n) : 0.0};
}

std::string SeedTable::markdown() const {
  std::map<int, Tally> methods;
  for (const RunSummary& run : runs) methods[run.method].add(run);
  std::string table =
      "| " + scenario +
      " | runs | goal | contact | at fault | other | time to goal [s] | nearest person [m] |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const auto& [number, tally] : methods) {
    const MeanInterval time = meanInterval(tally.times_s);
    table +=
        "| Method " + std::to_string(number) + ": " + tally.name + " | " +
        std::to_string(tally.runs) + " | " + std::to_string(tally.goals) + " | " +
        std::to_string(tally.contacts) + " | " + std::to_string(tally.atFault) + " | " +
        std::to_string(tally.other) + " | " +
        (tally.times_s.empty() ? std::string("-")
                               : text("%.1f", time.mean) + text(" +/- %.1f", time.half)) +
        " | " +
        (std::isinf(tally.minClearance_m) ? std::string("-")
                                          : text("%.2f", std::max(0.0, tally.minClearance_m))) +
        " |\n";
  }
  return table;
}

std::string SeedTable::csv() const {
  const auto orEmpty = [](const std::optional<double>& value) {
    return value ? text("%.4f", *value) : std::string();
  };
  std::string rows =
      "scenario,seed,method,outcome,contact,at_fault,impact_speed_mps,min_clearance_m,time_to_goal_"
      "s,path_length_m,"
      "time_stopped_s,blind_spots_mean\n";
  for (const RunSummary& run : runs)
    rows += quoted(scenario) + "," + std::to_string(run.seed) + "," + std::to_string(run.method) +
            "," + nameOf(run.outcome) + "," + std::to_string(int{run.contact}) + "," +
            std::to_string(int{run.atFault}) + "," + orEmpty(run.impactSpeed_mps) + "," +
            orEmpty(run.minClearance_m) + "," + orEmpty(run.timeToGoal_s) + "," +
            text("%.4f", run.pathLength_m) + "," + text("%.2f", run.timeStopped_s) + "," +
            text("%.3f", run.blindSpotsMean) + "\n";
  return rows;
}

}  // namespace bslnav
