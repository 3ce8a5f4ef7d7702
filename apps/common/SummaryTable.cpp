#include "SummaryTable.h"

#include <algorithm>
#include <cstdio>
#include <iomanip>
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

using Rows = std::vector<std::pair<const char*, std::string>>;

/** What only a driven run has. */
void addDriven(const RunSummary& s, Rows& rows) {
  rows.emplace_back("outcome", s.reason.empty()
                                   ? nameOf(s.outcome)
                                   : std::string(nameOf(s.outcome)) + " (" + s.reason + ")");
  rows.emplace_back("time to goal", orDash("%.1f s", s.timeToGoal_s) +
                                        (s.goalMoved ? " (to the nearest reachable place)" : ""));
  rows.emplace_back("path", text("%.2f m", s.pathLength_m) +
                                text(", mean %.2f m/s", s.meanSpeed_mps) +
                                text(", stopped %.1f s", s.timeStopped_s));
  rows.emplace_back("nearest person", orDash("%.2f m", notBelowZero(s.minClearance_m)));
  rows.emplace_back("impact speed", orDash("%.2f m/s", s.impactSpeed_mps));
}

/** What the guard makes of a recorded drive. */
void addAudit(const GuardFindings& g, Rows& rows) {
  const double scans = std::max(1.0, static_cast<double>(g.scans));
  const double jumps = std::max(1.0, static_cast<double>(g.jumps)) / 100.0;
  const double cycles = std::max(1.0, static_cast<double>(g.drivingCycles)) / 100.0;
  rows.emplace_back("frontiers",
                    text("%.1f a scan, beside ", static_cast<double>(g.frontiers) / scans) +
                        text("%.1f jumps", static_cast<double>(g.jumps) / scans));
  rows.emplace_back(
      "jumps", text("%.1f %% with a frontier behind, ", static_cast<double>(g.plausible) / jumps) +
                   text("%.1f %% too far, ", static_cast<double>(g.tooFar) / jumps) +
                   text("%.1f %% where nobody fits, ", static_cast<double>(g.nobodyFits) / jumps) +
                   text("%.1f %% seen empty before", static_cast<double>(g.seenEmpty) / jumps));
  rows.emplace_back("bound", text("exceeded in %.1f %% of the cycles in which the robot drove, ",
                                  static_cast<double>(g.exceededCycles) / cycles) +
                                 text("by %.2f m/s at most", g.mostExceeded_mps));
}

/** What only an offline evaluation has. */
void addEvaluated(const RunSummary& s, const RawlogFindings& f, Rows& rows) {
  rows.emplace_back("evaluated", std::to_string(s.cycles) + (s.cycles == 1 ? " frame" : " frames") +
                                     (s.reason.empty() ? std::string() : "; " + s.reason));
  rows.emplace_back(
      "recorded",
      text("%.1f s", f.recorded_s) + text(", %.1f m, ", f.recordedPath_m) + measurementsOf(f) +
          (f.scans > 0 ? text(", %.1f %% of the beams unusable", f.unusableBeams_percent) : ""));
  rows.emplace_back("localisation", text("%.3f m mean spread", f.meanSpread_m));
  rows.emplace_back(
      "planner",
      text("%.2f m/s", f.speedDifferenceMean_mps) +
          text(" and %.2f rad/s from the recording in the mean,", f.yawRateDifferenceMean_radps) +
          text(" slower in %.0f %% of the cycles", f.slowerThanRecorded_percent));
  if (f.guard) addAudit(*f.guard, rows);
  rows.emplace_back("speed", text("%.0f times faster than the recording", f.recorded_s / f.wall_s));
}

}  // namespace

void printSummary(std::ostream& out, const std::string& name, const RunSummary& s,
                  const std::string& directory, const std::vector<std::string>& pictures) {
  Rows rows{{"method",
             std::to_string(s.method) + " (" + s.methodName + "), seed " + std::to_string(s.seed)}};
  if (s.rawlog)
    addEvaluated(s, *s.rawlog, rows);
  else
    addDriven(s, rows);
  if (!s.sensorProblem.empty())
    rows.emplace_back("sensors", std::to_string(s.unhealthyCycles) +
                                     " cycles without, first: " + s.sensorProblem);
  rows.emplace_back("blind spots", text("%.1f a cycle", s.blindSpotsMean));
  rows.emplace_back("cycle", text("%.2f ms median", s.cycle_ms.p50) +
                                 text(", %.2f ms 99 %%", s.cycle_ms.p99) +
                                 text(", %.2f ms max", s.cycle_ms.max));
  rows.emplace_back("files", directory + "/{summary.json,cycles.csv,config.ini}");
  for (const auto& picture : pictures) rows.emplace_back("picture", picture);
  out << name << '\n';
  for (const auto& [label, value] : rows)
    out << "  " << std::left << std::setw(16) << label << value << '\n';
}

std::string progressLine(const CycleRecord& record) {
  return text("t = %.1f s", record.time_s) + text(", x = %.2f m", record.mapFromRobot.x) +
         text(", y = %.2f m", record.mapFromRobot.y) + text(", %.2f m/s", speedOf(record.twist));
}

int exitCodeOf(const RunSummary& summary) {
  return summary.outcome == Outcome::Goal || summary.outcome == Outcome::Contact ? 0 : 1;
}

}  // namespace bslnav
