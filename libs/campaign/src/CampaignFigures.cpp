#include <bslnav/campaign/CampaignResults.h>
#include <bslnav/evaluation/RunTally.h>
#include <bslnav/pictures/TimeChart.h>

#include <algorithm>

namespace bslnav {
namespace {

/** The colour of an entrant, the same in every figure. */
Colour colourOf(std::size_t entrant) {
  constexpr Colour kColours[] = {palette::kBlue,    palette::kOrange, palette::kGreen,
                                 palette::kMagenta, palette::kSky,    palette::kRed,
                                 palette::kInk};
  return kColours[entrant % (sizeof kColours / sizeof kColours[0])];
}

std::string encountersText(const std::vector<EntrantResult>& results) {
  return results.empty() ? "no runs"
                         : std::to_string(results.front().encounters) + " encounters an entrant";
}

/** What is drawn of an entrant's distribution. */
using Values = std::vector<double> EntrantResult::*;

/** Draws which share of an entrant's encounters has a value of at most x. */
void saveDistribution(const std::vector<EntrantResult>& results, Values values, TimeChart chart,
                      const std::string& path) {
  double most = 0.0;
  for (const EntrantResult& result : results)
    for (const double value : result.*values) most = std::max(most, value);
  for (std::size_t i = 0; i < results.size(); ++i) {
    std::vector<double> x{0.0}, share{0.0}, sorted = results[i].*values;
    std::sort(sorted.begin(), sorted.end());
    for (const double value : sorted) {
      x.push_back(value);
      share.push_back(100.0 * static_cast<double>(x.size() - 1) /
                      static_cast<double>(results[i].encounters));
    }
    x.push_back(most);
    share.push_back(share.back());
    chart.series(results[i].name(), x, share, {SeriesStyle::Form::Steps, colourOf(i)});
  }
  chart.save(path);
}

/** Each entrant as a point with its 95 % interval; one that never reached the goal has no time. */
void saveFaults(const std::vector<EntrantResult>& results, const std::string& path) {
  TimeChart chart("Contacts at fault against time", encountersText(results) + ", 95 % intervals",
                  "mean time to the goal [s]", 1400, 520);
  chart.panel("contacts at fault [% of encounters]");
  double slowest_s = 0.0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i].times_s.empty()) continue;
    const double time_s = meanInterval(results[i].times_s).mean;
    const Share fault = wilson(results[i].atFault, results[i].encounters);
    chart.series("", {time_s, time_s}, {100.0 * fault.low, 100.0 * fault.high},
                 {SeriesStyle::Form::Line, colourOf(i), 2.0});
    chart.series(results[i].name(), {time_s}, {100.0 * fault.share},
                 {SeriesStyle::Form::Points, colourOf(i), 9.0});
    slowest_s = std::max(slowest_s, time_s);
  }
  chart.series("", {0.0, 1.05 * slowest_s}, {0.0, 0.0},
               {SeriesStyle::Form::Line, palette::kFaintInk, 1.0});
  chart.save(path);
}

}  // namespace

std::vector<std::string> saveCampaignFigures(const std::vector<EntrantResult>& results,
                                             const std::string& directory) {
  std::vector<std::string> paths{directory + "/figure-faults.png", directory + "/figure-times.png",
                                 directory + "/figure-clearances.png"};
  saveFaults(results, paths[0]);
  TimeChart times("Time to the goal", encountersText(results), "time [s]", 1400, 440);
  times.panel("at the goal by then [% of encounters]");
  saveDistribution(results, &EntrantResult::times_s, times, paths[1]);
  TimeChart clearances("Least distance to people", encountersText(results),
                       "least distance in an encounter [m]", 1400, 440);
  clearances.panel("at most this near [% of encounters]");
  saveDistribution(results, &EntrantResult::clearances_m, clearances, paths[2]);
  return paths;
}

}  // namespace bslnav
