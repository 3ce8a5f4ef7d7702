#include <bslnav/campaign/CampaignResults.h>
#include <bslnav/evaluation/RunTally.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numeric>

namespace bslnav {
namespace {

std::string text(const char* format, double value) {
  char digits[48];
  std::snprintf(digits, sizeof digits, format, value);
  return digits;
}

std::string meanCell(const std::vector<double>& values, const char* format) {
  return values.empty() ? "-" : text(format, meanInterval(values).mean);
}

double percent(long part, long whole) {
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

/** The value below which 5 % are; 0 for none. */
double lowest5Percent(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto rank = static_cast<std::ptrdiff_t>(values.size() / 20);
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

std::string line(const EntrantResult& r) {
  const Share fault = wilson(r.atFault, r.encounters);
  const std::string empty = r.emptyTimes_s.empty() ? "-" : meanCell(r.emptyTimes_s, "%.1f");
  return "| " + std::to_string(r.method) + " | " + r.engine + " | " + r.sensors + " | " +
         std::to_string(r.encounters) + " | " + text("%.1f", percent(r.goals, r.encounters)) +
         " | " + text("%.1f", 100.0 * r.goalShareWithoutContact()) + " | " +
         std::to_string(r.contacts) + " | " + std::to_string(r.atFault) + " | " +
         text("%.2f", 100.0 * fault.low) + " to " + text("%.2f", 100.0 * fault.high) + " | " +
         meanCell(r.impacts_mps, "%.2f") + " | " + text("%.2f", lowest5Percent(r.clearances_m)) +
         " | " + meanCell(r.times_s, "%.1f") + " | " + empty + " | " +
         text("%.1f", r.standing_s / static_cast<double>(r.encounters)) + " | " +
         text("%.2f", percent(r.lapsed, r.encounters)) + " |\n";
}

std::string familyTable(const std::vector<EntrantResult>& results) {
  std::string header = "| method | engine | sensors |", rule = "|---|---|---|", lines;
  for (const auto& [family, counts] : results.front().families) {
    header += " " + family + " |";
    rule += "---|";
  }
  for (const EntrantResult& r : results) {
    lines += "| " + std::to_string(r.method) + " | " + r.engine + " | " + r.sensors + " |";
    for (const auto& [family, counts] : r.families)
      lines += " " + std::to_string(counts.first) + " (" + std::to_string(counts.second) + ") |";
    lines += "\n";
  }
  return header + "\n" + rule + "\n" + lines;
}

}  // namespace

std::string campaignTables(const std::vector<EntrantResult>& results) {
  if (results.empty()) return "no runs\n";
  std::string table =
      "| method | engine | sensors | encounters | goal [%] | goal without contact [%] | contacts | "
      "at fault | at fault, 95 % interval [%] | impact at fault [m/s] | nearest, 5 % [m] | time "
      "[s] | with nobody there [s] | standing [s] | lapsed [%] |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const EntrantResult& result : results) table += line(result);
  std::string yardstick;
  for (const EntrantResult& r : results)
    if (!r.toYardstick.empty())
      yardstick += "- " + r.name() + ": " + meanCell(r.toYardstick, "%.3f") + " (" +
                   std::to_string(r.toYardstick.size()) + " openings)\n";
  if (!yardstick.empty())
    yardstick =
        "\nTime past a one-sided opening with nobody there, over the least that lets the "
        "robot stand before whoever steps out:\n\n" +
        yardstick;
  return table + yardstick + "\nContacts, and in brackets those at fault, by family:\n\n" +
         familyTable(results);
}

std::string campaignJson(const std::vector<EntrantResult>& results) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const EntrantResult& r : results) {
    const Share fault = wilson(r.atFault, r.encounters);
    nlohmann::ordered_json entry;
    entry["method"] = r.method;
    entry["engine"] = r.engine;
    entry["sensors"] = r.sensors;
    entry["encounters"] = r.encounters;
    entry["goals"] = r.goals;
    entry["goal_share_without_contact"] = r.goalShareWithoutContact();
    entry["contacts"] = r.contacts;
    entry["at_fault"] = r.atFault;
    entry["at_fault_share_95"] = {fault.low, fault.high};
    entry["impact_at_fault_mean_mps"] = meanInterval(r.impacts_mps).mean;
    entry["clearance_5_percent_m"] = lowest5Percent(r.clearances_m);
    entry["time_to_goal_mean_s"] = meanInterval(r.times_s).mean;
    entry["time_to_goal_median_s"] = median(r.times_s);
    entry["time_empty_mean_s"] = meanInterval(r.emptyTimes_s).mean;
    if (!r.toYardstick.empty())
      entry["time_over_yardstick_mean"] = meanInterval(r.toYardstick).mean;
    entry["time_stopped_mean_s"] = r.standing_s / static_cast<double>(r.encounters);
    entry["lapsed_encounters"] = r.lapsed;
    entry["lapse_s"] = r.lapse_s;
    for (const auto& [family, counts] : r.families)
      entry["families"][family] = {{"contacts", counts.first}, {"at_fault", counts.second}};
    all.push_back(std::move(entry));
  }
  return all.dump(2) + "\n";
}

}  // namespace bslnav
