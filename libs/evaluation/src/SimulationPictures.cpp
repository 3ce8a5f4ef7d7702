#include <bslnav/evaluation/PictureStyles.h>
#include <bslnav/evaluation/SimulationPictures.h>
#include <bslnav/pictures/TimeChart.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

std::string number(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string outcomeText(const RunSummary& s) {
  std::string text = nameOf(s.outcome);
  if (s.timeToGoal_s)
    text += number(" after %.1f s", *s.timeToGoal_s);
  else
    text += number(" at %.1f s", s.duration_s);
  if (s.impactSpeed_mps) text += number(", robot at %.2f m/s", *s.impactSpeed_mps);
  if (s.minClearance_m) text += number(", nearest person %.2f m", std::max(0.0, *s.minClearance_m));
  return text + ", seed " + std::to_string(s.seed);
}

}  // namespace

SimulationPictures::SimulationPictures(const SimulationSetup& setup,
                                       std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> map)
    : setup_(setup), map_(std::move(map)), snapshots_(setup.navigation.footprint) {
  if (map_) {
    bounds_ = {map_->getXMin(), map_->getYMin(), map_->getXMax(), map_->getYMax()};
    return;
  }
  const auto& start = setup.scenario.start;
  bounds_ = {start.x, start.y, start.x, start.y};
  for (const auto& goal : setup.scenario.goals)
    bounds_ = {std::min(bounds_.xMin_m, goal.x), std::min(bounds_.yMin_m, goal.y),
               std::max(bounds_.xMax_m, goal.x), std::max(bounds_.yMax_m, goal.y)};
  bounds_ = {bounds_.xMin_m - 3, bounds_.yMin_m - 3, bounds_.xMax_m + 3, bounds_.yMax_m + 3};
}

void SimulationPictures::observe(const SimulationMoment& moment) {
  const SimulationState& truth = moment.truth;
  time_s_.push_back(truth.time_s);
  speed_mps_.push_back(truth.twist.vx);
  command_mps_.push_back(moment.record.motion.command.vx);
  clearance_m_.push_back(truth.clearanceToPeople_m);
  positions_.emplace_back(truth.pose.x, truth.pose.y);
  people_.resize(truth.people.size());
  for (std::size_t i = 0; i < people_.size(); ++i) people_[i].push_back(truth.people[i].position);
  if (firstPath_.empty()) firstPath_ = moment.record.path;
  lastPose_ = truth.pose;
  lastPeople_ = truth.people;
  const auto& times = setup_.pictures.snapshots_s;
  if (nextSnapshot_ < times.size() && truth.time_s >= times[nextSnapshot_] - 1e-6) {
    std::vector<SnapshotPerson> people;
    for (const auto& person : truth.people) people.push_back({person.position, person.radius_m});
    snapshots_.add(moment.record, moment.cycle, people, bounds_);
    ++nextSnapshot_;
  }
}

void SimulationPictures::drawWorld(MapPicture& picture) const {
  if (map_) picture.occupancy(*map_);
  for (const auto& [name, c] : setup_.world.cylinders)
    if (!c.mapped || !map_)
      picture.disc({c.x_m, c.y_m}, c.radius_m, style::kUnmapped, "pole, not in the map");
  for (const auto& [name, b] : setup_.world.boxes)
    if (!b.mapped || !map_) {
      const double x = 0.5 * b.length_m, y = 0.5 * b.width_m;
      picture.outline(b.pose, Footprint{0.0, {{x, y}, {-x, y}, {-x, -y}, {x, -y}}},
                      style::kUnmapped, "box, not in the map");
    }
  for (const auto& [name, person] : setup_.world.pedestrians)
    if (person.triggerLine_m.size() == 2)
      picture.segment(person.triggerLine_m[0], person.triggerLine_m[1], style::kTrigger,
                      "person starts");
}

MapPicture SimulationPictures::trajectoryPicture(const RunSummary& summary) const {
  MapPicture picture(setup_.scenario.name + ", Method " + std::to_string(summary.method) + ": " +
                         summary.methodName,
                     outcomeText(summary), bounds_);
  drawWorld(picture);
  picture.polyline(firstPath_, style::kGlobalPath, "global path at the start");
  for (std::size_t i = 0; i < people_.size(); ++i) {
    picture.polyline(people_[i], style::kWalk, "person's walk");
    picture.disc(lastPeople_[i].position, lastPeople_[i].radius_m, style::kPerson,
                 "person at the end");
  }
  picture.trajectory(positions_, speed_mps_, setup_.navigation.limits.maxSpeed_mps, "driven path");
  picture.outline(lastPose_, setup_.navigation.footprint, style::kRobot, "robot at the end");
  picture.marker(MarkerKind::Start, {setup_.scenario.start.x, setup_.scenario.start.y}, "start");
  for (const auto& goal : setup_.scenario.goals)
    picture.marker(MarkerKind::Goal, {goal.x, goal.y},
                   &goal == &setup_.scenario.goals.back() ? "goal" : "");
  if (summary.contact) picture.marker(MarkerKind::Contact, positions_.back(), "contact");
  return picture;
}

std::vector<std::string> SimulationPictures::save(const RunSummary& summary,
                                                  const std::string& directory) const {
  std::vector<std::string> paths{directory + "/trajectory.png", directory + "/speed.png"};
  trajectoryPicture(summary).save(paths[0]);

  TimeChart chart(setup_.scenario.name + ", Method " + std::to_string(summary.method),
                  outcomeText(summary), "time [s]");
  chart.panel("speed [m/s]");
  chart.series("commanded", time_s_, command_mps_,
               {SeriesStyle::Form::Steps, palette::kSky, 2.0, false});
  chart.series("driven", time_s_, speed_mps_,
               {SeriesStyle::Form::Line, palette::kBlue, 2.5, false});
  chart.limit(setup_.navigation.limits.maxSpeed_mps, palette::kFaintInk, "limit");
  if (!people_.empty()) {
    chart.panel("to people [m]");
    chart.series("clearance", time_s_, clearance_m_,
                 {SeriesStyle::Form::Line, palette::kMagenta, 2.5, false});
  }
  chart.save(paths[1]);

  if (!snapshots_.empty()) {
    paths.push_back(directory + "/snapshots.png");
    snapshots_.save(paths.back(), setup_.scenario.name + ", Method " +
                                      std::to_string(summary.method) + ": cost map and candidates");
  }
  return paths;
}

}  // namespace bslnav
