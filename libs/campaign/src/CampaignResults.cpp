#include <bslnav/campaign/CampaignResults.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

void add(EntrantResult& result, const CampaignRow& row) {
  ++result.encounters;
  result.goals += row.outcome == "goal";
  result.contacts += row.contact;
  result.atFault += row.atFault;
  result.lapsed += row.lapse_s > 0.0;
  result.lapse_s += row.lapse_s;
  result.standing_s += row.timeStopped_s;
  if (row.timeToGoal_s) result.times_s.push_back(*row.timeToGoal_s);
  if (row.timeEmpty_s) result.emptyTimes_s.push_back(*row.timeEmpty_s);
  if (row.timeEmpty_s && row.yardstick_s)
    result.toYardstick.push_back(*row.timeEmpty_s / *row.yardstick_s);
  if (row.minClearance_m) result.clearances_m.push_back(std::max(0.0, *row.minClearance_m));
  if (row.atFault && row.impactSpeed_mps) result.impacts_mps.push_back(*row.impactSpeed_mps);
  auto& family = result.families[row.family];
  family.first += row.contact;
  family.second += row.atFault;
}

}  // namespace

Share wilson(long hits, long trials) {
  if (trials <= 0) return {};
  constexpr double z = 1.959964;
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(hits) / n, scale = 1.0 / (1.0 + z * z / n);
  const double middle = (p + z * z / (2.0 * n)) * scale;
  const double half = z * scale * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
  return {p, std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

std::string EntrantResult::name() const {
  return "Method " + std::to_string(method) + ", " + engine + ", " + sensors;
}

double EntrantResult::goalShareWithoutContact() const {
  const long without = encounters - contacts;
  return without > 0 ? static_cast<double>(goals) / static_cast<double>(without) : 0.0;
}

std::vector<EntrantResult> resultsOf(const std::vector<CampaignRow>& rows) {
  std::vector<EntrantResult> results;
  for (const CampaignRow& row : rows) {
    auto result = std::find_if(results.begin(), results.end(), [&row](const EntrantResult& other) {
      return other.method == row.method && other.engine == row.engine &&
             other.sensors == row.sensors;
    });
    if (result == results.end()) {
      result = results.insert(results.end(), EntrantResult{});
      result->method = row.method;
      result->engine = row.engine;
      result->sensors = row.sensors;
    }
    add(*result, row);
  }
  return results;
}

}  // namespace bslnav
