#include <bslnav/campaign/CampaignResults.h>
#include <bslnav/evaluation/RunTally.h>
#include <bslnav/pictures/TimeChart.h>

#include <algorithm>

namespace bslnav {
namespace {

/** Draws which share of some values is at most x. */
void distribution(TimeChart& chart, const std::string& label, std::vector<double> values,
                  std::size_t whole) {
  if (values.empty()) return;
  std::sort(values.begin(), values.end());
  std::vector<double> shares(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    shares[i] = 100.0 * static_cast<double>(i + 1) / static_cast<double>(whole);
  chart.series(label, values, shares, {SeriesStyle::Form::Steps});
}

std::string encountersText(const std::vector<EntrantResult>& results) {
  return results.empty() ? "no runs"
                         : std::to_string(results.front().encounters) + " encounters an entrant";
}

void saveFaults(const std::vector<EntrantResult>& results, const std::string& path) {
  TimeChart chart("Contacts at fault against time", encountersText(results),
                  "mean time to the goal [s]", 1400, 520);
  chart.panel("contacts at fault [% of encounters]");
  for (const EntrantResult& result : results) {
    const double time_s = meanInterval(result.times_s).mean;
    const Share fault = wilson(result.atFault, result.encounters);
    chart.series(result.name(), {time_s}, {100.0 * fault.share},
                 {SeriesStyle::Form::Points, {}, 9.0});
  }
  chart.save(path);
}

}  // namespace

std::vector<std::string> saveCampaignFigures(const std::vector<EntrantResult>& results,
                                             const std::string& directory) {
  std::vector<std::string> paths{directory + "/figure-faults.png", directory + "/figure-times.png",
                                 directory + "/figure-clearances.png"};
  saveFaults(results, paths[0]);
  TimeChart times("Time to the goal", encountersText(results), "time to the goal [s]", 1400, 440);
  times.panel("at the goal by then [% of encounters]");
  TimeChart clearances("Least distance to people", encountersText(results),
                       "least distance in an encounter [m]", 1400, 440);
  clearances.panel("at most this near [% of encounters]");
  for (const EntrantResult& result : results) {
    distribution(times, result.name(), result.times_s, static_cast<std::size_t>(result.encounters));
    distribution(clearances, result.name(), result.clearances_m, result.clearances_m.size());
  }
  times.save(paths[1]);
  clearances.save(paths[2]);
  return paths;
}

}  // namespace bslnav
