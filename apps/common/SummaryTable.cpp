#include "SummaryTable.h"

#include <algorithm>
#include <cstdio>
#include <ostream>

namespace bslnav {
namespace {

std::string text(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

std::string orDash(const char* format, const std::optional<double>& value) {
  return value ? text(format, *value) : std::string("-");
}

/** In contact a clearance may come out a little negative, by what was driven in one step of the
 * simulator. */
std::optional<double> notBelowZero(const std::optional<double>& value) {
  return value ? std::optional<double>(std::max(0.0, *value)) : value;
}

}  // namespace

void printSummary(std::ostream& out, const std::string& name, const RunSummary& s,
                  const std::string& directory, const std::vector<std::string>& pictures) {
  const std::string outcome =
      s.reason.empty() ? nameOf(s.outcome) : std::string(nameOf(s.outcome)) + " (" + s.reason + ")";
  const std::pair<const char*, std::string> rows[] = {
      {"method",
       std::to_string(s.method) + " (" + s.methodName + "), seed " + std::to_string(s.seed)},
      {"outcome", outcome},
      {"time to goal", orDash("%.1f s", s.timeToGoal_s)},
      {"path", text("%.2f m", s.pathLength_m) + text(", mean %.2f m/s", s.meanSpeed_mps) +
                   text(", stopped %.1f s", s.timeStopped_s)},
      {"nearest person", orDash("%.2f m", notBelowZero(s.minClearance_m))},
      {"impact speed", orDash("%.2f m/s", s.impactSpeed_mps)},
      {"blind spots", text("%.1f a cycle", s.blindSpotsMean)},
      {"cycle", text("%.2f ms median", s.cycle_ms.p50) + text(", %.2f ms 99 %%", s.cycle_ms.p99) +
                    text(", %.2f ms max", s.cycle_ms.max)},
  };
  out << name << '\n';
  for (const auto& [label, value] : rows) {
    char line[256];
    std::snprintf(line, sizeof line, "  %-15s %s\n", label, value.c_str());
    out << line;
  }
  out << "  files           " << directory << "/{summary.json,cycles.csv,config.ini}\n";
  for (const auto& picture : pictures) out << "  picture         " << picture << '\n';
}

std::string progressLine(const CycleRecord& record) {
  return text("t = %.1f s", record.time_s) + text(", x = %.2f m", record.mapFromRobot.x) +
         text(", y = %.2f m", record.mapFromRobot.y) + text(", %.2f m/s", record.twist.vx);
}

int exitCodeOf(const RunSummary& summary) {
  return summary.outcome == Outcome::Goal || summary.outcome == Outcome::Contact ? 0 : 1;
}

}  // namespace bslnav
