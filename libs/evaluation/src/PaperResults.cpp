#include <bslnav/config/Version.h>
#include <bslnav/evaluation/PaperNumbers.h>
#include <bslnav/evaluation/PaperResults.h>
#include <bslnav/evaluation/RunTally.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "RunCells.h"

namespace bslnav {
namespace {

using Json = nlohmann::ordered_json;

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json toJson(const RunSummary& run) {
  return {{"seed", run.seed},
          {"outcome", nameOf(run.outcome)},
          {"reason", run.reason},
          {"contact", run.contact},
          {"at_fault", run.atFault},
          {"impact_speed_mps", orNull(run.impactSpeed_mps)},
          {"min_clearance_m", orNull(run.minClearance_m)},
          {"time_to_goal_s", orNull(run.timeToGoal_s)},
          {"duration_s", run.duration_s},
          {"path_length_m", run.pathLength_m},
          {"mean_speed_mps", run.meanSpeed_mps},
          {"time_stopped_s", run.timeStopped_s},
          {"blind_spots_mean", run.blindSpotsMean}};
}

Json toJson(const RunTally& tally) {
  const MeanInterval time = meanInterval(tally.times_s);
  const auto& near_m = tally.clearance_m;
  const auto nearest = std::min_element(near_m.begin(), near_m.end());
  const auto unless = [](bool nothing, double value) {
    return nothing ? Json(nullptr) : Json(value);
  };
  return {{"runs", tally.runs},
          {"goals", tally.goals},
          {"contacts", tally.contacts},
          {"at_fault", tally.atFault},
          {"other", tally.other},
          {"time_to_goal_mean_s", unless(tally.times_s.empty(), time.mean)},
          {"time_to_goal_interval_s", unless(tally.times_s.empty(), time.half)},
          {"min_clearance_min_m", near_m.empty() ? Json(nullptr) : Json(*nearest)},
          {"min_clearance_median_m", unless(near_m.empty(), median(near_m))}};
}

Json paperOf(const PaperResult& result) {
  const auto paper = paperNumbers(result.caseName, result.method);
  if (!paper) return nullptr;
  return {{"outcome", nameOf(paper->outcome)}, {"time_to_goal_s", orNull(paper->time_s)}};
}

}  // namespace

std::vector<PaperResult> paperResults(const std::vector<ExperimentCase>& cases,
                                      const std::vector<NominalRun>& nominal,
                                      const std::vector<ExperimentResult>& seeds) {
  std::vector<PaperResult> results;
  for (const ExperimentCase& entry : cases) {
    PaperResult result{entry.name,   entry.setup.scenario.name,
                       entry.method, entry.setup.navigation.method.name,
                       std::nullopt, {}};
    for (const NominalRun& run : nominal)
      if (run.entry.name == entry.name && run.entry.method == entry.method)
        result.nominal = run.summary;
    for (const ExperimentResult& seed : seeds)
      if (seed.run.caseName == entry.name && seed.run.method == entry.method)
        result.seeds.push_back(seed.summary);
    results.push_back(std::move(result));
  }
  return results;
}

std::string resultsCsv(const std::vector<PaperResult>& results) {
  std::string rows = std::string("case,method,seed,") + kRunColumns + "\n";
  for (const PaperResult& result : results)
    for (const RunSummary& run : result.seeds)
      rows += csvField(result.caseName) + "," + std::to_string(result.method) + "," +
              std::to_string(run.seed) + "," + runCells(run) + "\n";
  return rows;
}

std::string resultsJson(const std::vector<PaperResult>& results) {
  Json entries = Json::array();
  for (const PaperResult& result : results) {
    Json runs = Json::array();
    for (const RunSummary& run : result.seeds) runs.push_back(toJson(run));
    entries.push_back({{"case", result.caseName},
                       {"scenario", result.title},
                       {"method", result.method},
                       {"method_name", result.methodName},
                       {"paper", paperOf(result)},
                       {"nominal", result.nominal ? toJson(*result.nominal) : Json(nullptr)},
                       {"seeds", toJson(tallyOf(result.seeds))},
                       {"runs", std::move(runs)}});
  }
  const Json all{{"version", version()}, {"results", std::move(entries)}};
  // Names from files and configurations may be anything; JSON is UTF-8.
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bslnav
