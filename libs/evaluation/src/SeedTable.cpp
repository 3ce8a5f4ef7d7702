#include <bslnav/evaluation/SeedTable.h>

#include <algorithm>
#include <map>

#include "NumberText.h"
#include "RunCells.h"

namespace bslnav {

std::string SeedTable::markdown() const {
  std::map<int, RunTally> methods;
  std::map<int, std::string> names;
  for (const RunSummary& run : runs) {
    methods[run.method].add(run);
    names[run.method] = run.methodName;
  }
  std::string table =
      "| " + scenario +
      " | runs | goal | contact | at fault | other | time to goal [s] | nearest person [m] |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const auto& [number, tally] : methods) {
    const auto& near_m = tally.clearance_m;
    table +=
        "| Method " + std::to_string(number) + ": " + names[number] + " | " +
        std::to_string(tally.runs) + " | " + std::to_string(tally.goals) + " | " +
        std::to_string(tally.contacts) + " | " + std::to_string(tally.atFault) + " | " +
        std::to_string(tally.other) + " | " + meanCell(tally.times_s) + " | " +
        (near_m.empty() ? "-"
                        : numberText("%.2f", *std::min_element(near_m.begin(), near_m.end()))) +
        " |\n";
  }
  return table;
}

std::string SeedTable::csv() const {
  std::string rows = std::string("scenario,seed,method,") + kRunColumns + "\n";
  for (const RunSummary& run : runs)
    rows += csvField(scenario) + "," + std::to_string(run.seed) + "," + std::to_string(run.method) +
            "," + runCells(run) + "\n";
  return rows;
}

}  // namespace bslnav
