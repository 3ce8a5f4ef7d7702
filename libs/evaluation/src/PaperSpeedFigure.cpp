// Speed and clearance of all methods over the distance driven.
#include <bslnav/evaluation/PaperFigures.h>
#include <bslnav/pictures/TimeChart.h>

#include <algorithm>
#include <array>

namespace bslnav {
namespace {

/** What a chart shows over the distance driven, cycle by cycle. */
using Values = std::vector<double> (*)(const RunTrace&);

std::vector<double> speeds(const RunTrace& trace) { return trace.speed_mps; }

/** In contact a clearance may come out a little negative, by what was driven in one step of the
 * simulator. */
std::vector<double> clearances(const RunTrace& trace) {
  std::vector<double> values = trace.clearance_m;
  for (double& value : values) value = std::max(0.0, value);
  return values;
}

/** A colour for each method; lines that lie on each other get thinner to the front. */
SeriesStyle styleOf(int method, std::size_t linesInFront) {
  constexpr std::array<Colour, 5> kColours{palette::kRejected, palette::kOrange, palette::kGreen,
                                           palette::kBlue, palette::kInk};
  const auto colour = static_cast<std::size_t>(method - 1) % kColours.size();
  return {SeriesStyle::Form::Line, kColours[colour], 2.0 + 2.0 * static_cast<double>(linesInFront),
          false};
}

struct Points {
  std::vector<double> x, y;

  void add(const NominalRun& run, Values values, std::size_t cycle) {
    x.push_back(run.trace.distance_m[cycle]);
    y.push_back(values(run.trace)[cycle]);
  }
};

/** Where people started to walk; those who walk from the beginning do not count. */
Points walkStarts(const std::vector<NominalRun>& runs, Values values) {
  Points points;
  for (const NominalRun& run : runs)
    for (const auto& cycle : run.trace.walkStarts)
      if (cycle && *cycle > 0) points.add(run, values, *cycle);
  return points;
}

Points contacts(const std::vector<NominalRun>& runs, Values values) {
  Points points;
  for (const NominalRun& run : runs)
    if (run.summary.contact) points.add(run, values, run.trace.distance_m.size() - 1);
  return points;
}

/** @param legend whether the panel names its lines */
void addPanel(TimeChart& chart, const std::vector<NominalRun>& runs, const std::string& label,
              Values values, bool legend) {
  chart.panel(label);
  for (std::size_t i = 0; i < runs.size(); ++i)
    chart.series(legend ? "Method " + std::to_string(runs[i].entry.method) : "",
                 runs[i].trace.distance_m, values(runs[i].trace),
                 styleOf(runs[i].entry.method, runs.size() - 1 - i));
  const auto add = [&](const std::string& name, const Points& points, Colour colour) {
    if (!points.x.empty())
      chart.series(legend ? name : "", points.x, points.y,
                   {SeriesStyle::Form::Points, colour, 4.5, false});
  };
  add("person starts", walkStarts(runs, values), palette::kMagenta);
  add("contact", contacts(runs, values), palette::kRed);
}

}  // namespace

Picture speedFigure(const std::vector<NominalRun>& runs) {
  TimeChart chart("Case " + runs.front().entry.setup.scenario.name + ": speed on the way",
                  "the scenario as written, seed " + std::to_string(runs.front().summary.seed),
                  "distance driven [m]", 1400, 260);
  addPanel(chart, runs, "speed [m/s]", speeds, true);
  chart.limit(runs.front().entry.setup.navigation.limits.maxSpeed_mps, palette::kFaintInk, "limit");
  bool people = false;
  for (const NominalRun& run : runs) people |= !run.trace.walks.empty();
  if (people) addPanel(chart, runs, "clearance to people [m]", clearances, false);
  return chart.finished();
}

}  // namespace bslnav
