#include <bslnav/evaluation/RunDrawing.h>
#include <bslnav/evaluation/SimulationPictures.h>
#include <bslnav/pictures/TimeChart.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

namespace bslnav {

SimulationPictures::SimulationPictures(const SimulationSetup& setup,
                                       std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> map)
    : setup_(setup), map_(std::move(map)) {}

void SimulationPictures::observe(const SimulationMoment& moment) {
  trace_.observe(moment, setup_.pictures.snapshots_s);
  const auto& due = setup_.pictures.depthStages_s;
  if (depthStages_.size() < due.size() && !moment.cycle.surroundings().depthFrames().empty() &&
      moment.record.time_s >= due[depthStages_.size()] - 1e-6)
    depthStages_.emplace_back(moment.record, moment.cycle, setup_.navigation);
}

std::vector<std::string> SimulationPictures::save(const RunSummary& summary,
                                                  const std::string& directory) const {
  std::vector<std::string> paths{directory + "/trajectory.png", directory + "/speed.png"};
  const std::string title = setup_.scenario.name + ", Method " + std::to_string(summary.method);
  const std::string subtitle = outcomeLine(summary) + ", seed " + std::to_string(summary.seed);
  const MapBounds bounds = boundsOf(setup_, map_.get());
  MapPicture trajectory(title + ": " + summary.methodName, subtitle, bounds);
  drawRun(trajectory, setup_, map_.get(), trace_, summary);
  trajectory.save(paths[0]);

  TimeChart chart(title, subtitle, "time [s]");
  chart.panel("speed [m/s]");
  chart.series("commanded", trace_.time_s, trace_.command_mps,
               {SeriesStyle::Form::Steps, palette::kSky, 2.0, false});
  chart.series("driven", trace_.time_s, trace_.speed_mps,
               {SeriesStyle::Form::Line, palette::kBlue, 2.5, false});
  chart.limit(setup_.navigation.limits.maxSpeed_mps, palette::kFaintInk, "limit");
  if (!trace_.walks.empty()) {
    chart.panel("to people [m]");
    chart.series("clearance", trace_.time_s, trace_.clearance_m,
                 {SeriesStyle::Form::Line, palette::kMagenta, 2.5, false});
  }
  chart.save(paths[1]);

  if (!trace_.snapshots.empty()) {
    paths.push_back(directory + "/snapshots.png");
    CycleSnapshots snapshots(setup_.navigation.footprint);
    for (const CycleSnapshot& snapshot : trace_.snapshots) snapshots.add(snapshot, bounds);
    snapshots.save(paths.back(), title + ": cost map and candidates");
  }
  for (std::size_t i = 0; i < depthStages_.size(); ++i)
    paths.push_back(depthStages_[i].save(directory, "depth-stages-" + std::to_string(i + 1),
                                         setup_.pictures.depthClouds));
  return paths;
}

}  // namespace bslnav
