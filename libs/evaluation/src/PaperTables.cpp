#include <bslnav/evaluation/PaperNumbers.h>
#include <bslnav/evaluation/PaperTables.h>
#include <bslnav/evaluation/RunTally.h>

#include <algorithm>

#include "NumberText.h"
#include "RunCells.h"

namespace bslnav {
namespace {

std::string row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

std::string header(const std::vector<std::string>& cells) {
  std::string line = row(cells) + "|";
  for (std::size_t i = 0; i < cells.size(); ++i) line += "---|";
  return line + "\n";
}

std::string orDash(const char* format, const std::optional<double>& value) {
  return value ? numberText(format, *value) : "-";
}

std::string methodCell(const PaperResult& result) {
  return std::to_string(result.method) + ": " + result.methodName;
}

const PaperResult* find(const std::vector<PaperResult>& results, const std::string& caseName,
                        int method) {
  for (const PaperResult& result : results)
    if (result.caseName == caseName && result.method == method) return &result;
  return nullptr;
}

std::optional<double> fasterBy(std::optional<double> faster_s, std::optional<double> slower_s) {
  if (!faster_s || !slower_s) return std::nullopt;
  return fasterBy_percent(*faster_s, *slower_s);
}

std::string nominalRow(const PaperResult& result) {
  const auto paper = paperNumbers(result.caseName, result.method);
  const auto& run = result.nominal;
  return row({result.title, methodCell(result), run ? nameOf(run->outcome) : "-",
              orDash("%.1f", run ? run->timeToGoal_s : std::nullopt),
              paper ? nameOf(paper->outcome) : "-",
              orDash("%.1f", paper ? paper->time_s : std::nullopt)});
}

/** Methods 4 and 2 of a case beside each other; empty unless both ran. */
std::string comparisonRow(const std::vector<PaperResult>& results, const std::string& caseName) {
  const PaperResult *second = find(results, caseName, 2), *fourth = find(results, caseName, 4);
  if (!second || !fourth || !second->nominal || !fourth->nominal) return "";
  const auto paperTime = [&caseName](int method) {
    const auto paper = paperNumbers(caseName, method);
    return paper ? paper->time_s : std::nullopt;
  };
  return row(
      {second->title, "4 faster than 2 by", "",
       orDash("%.1f %%", fasterBy(fourth->nominal->timeToGoal_s, second->nominal->timeToGoal_s)),
       "", orDash("%.1f %%", fasterBy(paperTime(4), paperTime(2)))});
}

std::string seedsRow(const PaperResult& result) {
  const RunTally tally = tallyOf(result.seeds);
  const auto& near_m = tally.clearance_m;
  const bool alone = near_m.empty();
  return row({result.title, methodCell(result), std::to_string(tally.runs),
              tally.runs == 0 ? "-" : numberText("%.1f", 100.0 * tally.goals / tally.runs),
              std::to_string(tally.contacts), std::to_string(tally.atFault),
              std::to_string(tally.other), meanCell(tally.times_s),
              alone ? "-" : numberText("%.2f", *std::min_element(near_m.begin(), near_m.end())),
              alone ? "-" : numberText("%.2f", median(near_m))});
}

}  // namespace

std::string nominalTable(const std::vector<PaperResult>& results) {
  std::string table = header({"case", "method", "here", "time [s]", "paper", "paper's time [s]"});
  for (std::size_t i = 0; i < results.size(); ++i) {
    table += nominalRow(results[i]);
    const bool last = i + 1 == results.size() || results[i + 1].caseName != results[i].caseName;
    if (last) table += comparisonRow(results, results[i].caseName);
  }
  return table;
}

std::string seedsTable(const std::vector<PaperResult>& results) {
  std::string table =
      header({"case", "method", "runs", "goal [%]", "contact", "at fault", "other",
              "time to goal [s]", "nearest person [m]", "median nearest person [m]"});
  for (const PaperResult& result : results) table += seedsRow(result);
  return table;
}

std::string paperTables(const std::vector<PaperResult>& results, const SeedRange& seeds) {
  return "## The scenarios as written, seed " + std::to_string(seeds.first) +
         ", beside the paper\n\n" + nominalTable(results) + "\n## Seeds " +
         std::to_string(seeds.first) + " to " + std::to_string(seeds.first + seeds.count - 1) +
         ": trigger lines, people's speeds and noise varied\n\n" + seedsTable(results) +
         "\nAt fault: the robot was faster than 0.05 m/s at contact. Times to the goal: mean of "
         "the "
         "runs that reached it, with its 95 % interval.\n";
}

}  // namespace bslnav
