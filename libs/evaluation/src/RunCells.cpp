#include "RunCells.h"

#include <bslnav/evaluation/RunTally.h>

#include "NumberText.h"

namespace bslnav {
namespace {

std::string orEmpty(const std::optional<double>& value) {
  return value ? numberText("%.4f", *value) : std::string();
}

}  // namespace

std::string runCells(const RunSummary& run) {
  return std::string(nameOf(run.outcome)) + "," + std::to_string(int{run.contact}) + "," +
         std::to_string(int{run.atFault}) + "," + orEmpty(run.impactSpeed_mps) + "," +
         orEmpty(run.minClearance_m) + "," + orEmpty(run.timeToGoal_s) + "," +
         numberText("%.4f", run.pathLength_m) + "," + numberText("%.2f", run.timeStopped_s) + "," +
         numberText("%.3f", run.blindSpotsMean);
}

std::string csvField(const std::string& field) {
  if (field.find_first_of(",\"\n") == std::string::npos) return field;
  std::string quotes = "\"";
  for (const char c : field) quotes += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quotes + "\"";
}

std::string meanCell(const std::vector<double>& values) {
  if (values.empty()) return "-";
  const MeanInterval interval = meanInterval(values);
  return numberText("%.1f", interval.mean) + numberText(" +/- %.1f", interval.half);
}

}  // namespace bslnav
