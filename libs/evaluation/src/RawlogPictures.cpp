#include <bslnav/evaluation/PictureStyles.h>
#include <bslnav/evaluation/RawlogPictures.h>
#include <bslnav/pictures/TimeChart.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace bslnav {
namespace {

std::string titleOf(const RawlogFindings& findings, const RunSummary& summary) {
  return std::filesystem::path(findings.log).filename().string() + ", Method " +
         std::to_string(summary.method);
}

std::string subtitleOf(const RawlogFindings& f, const RunSummary& summary) {
  char text[160];
  std::snprintf(text, sizeof text, "%.0f s, %.1f m, %s, %.1f blind spots a cycle", f.recorded_s,
                f.recordedPath_m, measurementsOf(f).c_str(), summary.blindSpotsMean);
  return text + (summary.reason.empty() ? std::string() : "; " + summary.reason);
}

/** The speed that 99 of 100 cycles stay below: a single odometry glitch must not take all colour
 * from a path. */
double usualTop(std::vector<double> speeds) {
  if (speeds.empty()) return 0.0;
  const auto top =
      speeds.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(speeds.size() - 1));
  std::nth_element(speeds.begin(), top, speeds.end());
  return *top;
}

}  // namespace

RawlogPictures::RawlogPictures(const RawlogSetup& setup, const LocalizedLog& log)
    : setup_(setup),
      log_(log),
      snapshots_(setup.navigation.footprint),
      worst_(setup.navigation.footprint) {
  constexpr double kMargin_m = 4.0;
  const auto& first = log.path.samples().front().pose;
  bounds_ = {first.x, first.y, first.x, first.y};
  for (const auto& sample : log.path.samples())
    bounds_ = {std::min(bounds_.xMin_m, sample.pose.x), std::min(bounds_.yMin_m, sample.pose.y),
               std::max(bounds_.xMax_m, sample.pose.x), std::max(bounds_.yMax_m, sample.pose.y)};
  bounds_ = {bounds_.xMin_m - kMargin_m, bounds_.yMin_m - kMargin_m, bounds_.xMax_m + kMargin_m,
             bounds_.yMax_m + kMargin_m};
}

void RawlogPictures::add(const GuardAudit& audit) {
  for (const CycleSnapshot& moment : audit.worst()) worst_.add(moment, bounds_);
}

void RawlogPictures::observe(const RawlogMoment& moment) {
  const CycleRecord& record = moment.record;
  time_s_.push_back(record.time_s);
  recorded_mps_.push_back(speedOf(record.twist, setup_.navigation.limits));
  chosen_mps_.push_back(speedOf(chosenVelocity(record)));
  recorded_radps_.push_back(record.twist.omega);
  chosen_radps_.push_back(chosenVelocity(record).omega);
  blindSpots_.push_back(static_cast<double>(record.blindSpots.size()));
  positions_.emplace_back(record.mapFromRobot.x, record.mapFromRobot.y);
  for (const BlindSpot& spot : record.blindSpots)
    spots_.push_back(record.mapFromRobot.composePoint(spot.position));
  const int due = setup_.rawlog.snapshots;
  if (snapshotsTaken_ < due && moment.progress >= (snapshotsTaken_ + 0.5) / due) {
    const Surroundings& surroundings = moment.cycle.surroundings();
    const People* people = surroundings.people();
    snapshots_.add(
        {record, surroundings.localCosts(), {}, people ? people->frontier() : Frontier{}}, bounds_);
    if (!moment.cycle.surroundings().depthFrames().empty())
      depthStages_.emplace_back(record, moment.cycle, setup_.navigation);
    ++snapshotsTaken_;
  }
}

MapPicture RawlogPictures::pathPicture(const RunSummary& summary) const {
  MapPicture picture(titleOf(log_.findings, summary), subtitleOf(log_.findings, summary), bounds_);
  if (log_.map) picture.occupancy(*log_.map);
  const std::size_t stride =
      1 + spots_.size() / 20000;  // enough to see where, few enough to see through
  for (std::size_t i = 0; i < spots_.size(); i += stride)
    picture.disc(spots_[i], 0.05, {palette::kOrange, i == 0 ? 0.6 : 0.15, 0.0}, "blind spot");
  picture.trajectory(positions_, recorded_mps_, std::max(0.1, usualTop(recorded_mps_)),
                     "recorded path");
  if (!positions_.empty()) {
    picture.marker(MarkerKind::Start, positions_.front(), "start");
    picture.marker(MarkerKind::Goal, positions_.back(), "end");
  }
  return picture;
}

std::vector<std::string> RawlogPictures::save(const RunSummary& summary,
                                              const std::string& directory) const {
  std::vector<std::string> paths{directory + "/path.png", directory + "/comparison.png"};
  pathPicture(summary).save(paths[0]);

  const SeriesStyle recorded{SeriesStyle::Form::Line, palette::kInk, 1.5, false};
  const SeriesStyle chosen{SeriesStyle::Form::Line, palette::kBlue, 1.5, false};
  TimeChart chart(titleOf(log_.findings, summary), subtitleOf(log_.findings, summary), "time [s]");
  chart.panel("speed [m/s]");
  chart.series("recorded", time_s_, recorded_mps_, recorded);
  chart.series("the planner's choice", time_s_, chosen_mps_, chosen);
  chart.panel("turning rate [rad/s]");
  chart.series("recorded", time_s_, recorded_radps_, recorded);
  chart.series("the planner's choice", time_s_, chosen_radps_, chosen);
  chart.panel("blind spots a cycle");
  chart.series("blind spots", time_s_, blindSpots_,
               {SeriesStyle::Form::Steps, palette::kOrange, 1.5, false});
  chart.save(paths[1]);

  if (!snapshots_.empty()) {
    paths.push_back(directory + "/snapshots.png");
    snapshots_.save(paths.back(), titleOf(log_.findings, summary));
  }
  if (!worst_.empty()) {
    paths.push_back(directory + "/worst-moments.png");
    worst_.save(paths.back(),
                titleOf(log_.findings, summary) + ": farthest above the bound as recorded");
  }
  for (std::size_t i = 0; i < depthStages_.size(); ++i)
    paths.push_back(depthStages_[i].save(directory, "depth-stages-" + std::to_string(i + 1),
                                         setup_.pictures.depthClouds));
  return paths;
}

}  // namespace bslnav
