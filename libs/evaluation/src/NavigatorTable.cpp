#include <bslnav/evaluation/NavigatorTable.h>
#include <bslnav/evaluation/RunTally.h>

#include <algorithm>

#include "NumberText.h"
#include "RunCells.h"

namespace bslnav {
namespace {

/** The runs of one line. */
struct Group {
  std::string name;
  RunTally tally;
  std::vector<double> cycles_ms;
};

std::string line(const Group& group) {
  const RunTally& t = group.tally;
  return "| " + group.name + " | " + std::to_string(t.runs) + " | " +
         numberText("%.0f", 100.0 * t.goals / t.runs) + " | " + std::to_string(t.contacts) + " | " +
         std::to_string(t.atFault) + " | " + std::to_string(t.other) + " | " + meanCell(t.times_s) +
         " | " + numberText("%.2f", median(group.cycles_ms)) + " |\n";
}

}  // namespace

std::string NavigatorTable::markdown() const {
  std::vector<Group> groups;
  for (const Row& row : rows) {
    const std::string name =
        row.scenario + " | " + row.navigator + " | " + std::to_string(row.run.method);
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const Group& other) { return other.name == name; });
    if (group == groups.end()) group = groups.insert(groups.end(), {name, {}, {}});
    group->tally.add(row.run);
    group->cycles_ms.push_back(row.run.cycle_ms.p50);
  }
  std::string table =
      "| case | navigator | method | runs | goal [%] | contact | at fault | other | time to goal "
      "[s] | cycle [ms] |\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Group& group : groups) table += line(group);
  return table;
}

std::string NavigatorTable::csv() const {
  std::string text = std::string("scenario,navigator,seed,method,") + kRunColumns + ",cycle_ms\n";
  for (const Row& row : rows)
    text += csvField(row.scenario) + "," + csvField(row.navigator) + "," +
            std::to_string(row.run.seed) + "," + std::to_string(row.run.method) + "," +
            runCells(row.run) + "," + numberText("%.4f", row.run.cycle_ms.p50) + "\n";
  return text;
}

}  // namespace bslnav
