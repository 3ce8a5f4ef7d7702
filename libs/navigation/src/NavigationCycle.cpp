#include <bslnav/costmap/InflationLayer.h>
#include <bslnav/navigation/NavigationCycle.h>
#include <mrpt/core/Clock.h>
#include <mrpt/system/CTicTac.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

double seconds(mrpt::system::CTicTac& watch) {
  const double elapsed = watch.Tac();
  watch.Tic();
  return elapsed;
}

}  // namespace

NavigationCycle::NavigationCycle(const NavigationParameters& parameters,
                                 std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> map)
    : parameters_(parameters),
      local_(parameters.costmap, parameters.footprint, map, Extent::Rolling),
      scanJumps_(parameters.scanJumps),
      globalPlanner_(parameters.globalPlanner),
      motionPlanner_(parameters.motion, parameters.recovery, parameters.dwa, parameters.limits,
                     FootprintCover(parameters.footprint, parameters.costmap.resolution_m,
                                    InflationLayer(parameters.costmap.inflation, local_.inscribedRadius_m(),
                                                   parameters.costmap.resolution_m)),
                     parameters.cycle.period_s) {
  if (map) global_.emplace(parameters.costmap, parameters.footprint, map, Extent::WholeMap);
  record_.index = -1;
}

void NavigationCycle::setGoals(std::vector<mrpt::math::TPose2D> goals) {
  goals_ = std::move(goals);
  nextGoal_ = 0;
  goalsChanged_ = true;
  motionPlanner_.reset();
}

const CycleRecord& NavigationCycle::step(const SensorFrame& frame) {
  mrpt::system::CTicTac whole, stage;
  whole.Tic();
  stage.Tic();
  ++record_.index;
  record_.health = takeOver(frame);
  record_.times = {};
  record_.motion = {};
  record_.replanned = false;
  if (record_.health != CycleRecord::Health::Ok) {
    record_.motion.command = brake(lastTwist_, parameters_.limits, parameters_.cycle.period_s);
    lastTwist_ = record_.motion.command;
    record_.times.total_s = whole.Tac();
    return record_;
  }
  lastTwist_ = record_.twist;
  findBlindSpots();
  record_.times.blindSpots_s = seconds(stage);

  local_.update(record_.mapFromRobot, scans_, record_.dangerZones);
  record_.times.costmap_s = seconds(stage);

  if (goals_.empty()) {
    record_.motion.command = brake(frame.twist, parameters_.limits, parameters_.cycle.period_s);
    record_.times.total_s = whole.Tac();
    return record_;
  }
  advanceWaypoint();
  if (goalsChanged_ || motionPlanner_.wantsReplan() ||
      record_.time_s - plannedAt_s_ >= parameters_.cycle.replanPeriod_s - 1e-6)
    planPath();
  record_.times.globalPlan_s = seconds(stage);

  record_.motion = motionPlanner_.step({record_.time_s, record_.mapFromRobot, record_.twist, record_.path,
                                        goals_.back(), nextGoal_ + 1 == goals_.size()},
                                       local_.costs());
  if (record_.motion.planned) record_.dwa = motionPlanner_.dwa();
  record_.times.motion_s = seconds(stage);
  record_.times.total_s = whole.Tac();
  return record_;
}

CycleRecord::Health NavigationCycle::takeOver(const SensorFrame& frame) {
  record_.time_s = frame.time_s;
  record_.mapFromRobot = frame.mapFromRobot;
  record_.twist = frame.twist;
  record_.beams = record_.droppedBeams = 0;
  scans_.resize(frame.scans.size());
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    scans_[i].assign(*frame.scans[i]);
    record_.beams += scans_[i].size();
    record_.droppedBeams += scans_[i].dropped();
    newestScan_s_ = std::max(newestScan_s_, mrpt::Clock::toDouble(frame.scans[i]->timestamp) - frame.startTime_s);
  }
  for (const double value : {frame.mapFromRobot.x, frame.mapFromRobot.y, frame.mapFromRobot.phi, frame.twist.vx,
                             frame.twist.omega})
    if (!std::isfinite(value)) return CycleRecord::Health::BadPose;
  // Between two scans of a slow sensor the robot goes on with what it knows, until that is stale.
  if (frame.time_s - newestScan_s_ > parameters_.cycle.sensorMaxAge_s) return CycleRecord::Health::StaleScan;
  if (record_.beams > 0 && record_.beams == record_.droppedBeams) return CycleRecord::Health::NoBeams;
  return CycleRecord::Health::Ok;
}

void NavigationCycle::findBlindSpots() {
  if (parameters_.blindSpots.source == BlindSpotSource::None || scans_.empty()) return;
  record_.blindSpots = scanJumps_.detect(scans_);
  record_.dangerZones.clear();
  for (const BlindSpot& spot : record_.blindSpots)
    record_.dangerZones.push_back(
        dangerZone(spot, record_.mapFromRobot, std::abs(record_.twist.vx), parameters_.dangerZone));
}

void NavigationCycle::advanceWaypoint() {
  const auto& pose = record_.mapFromRobot;
  while (nextGoal_ + 1 < goals_.size() &&
         std::hypot(goals_[nextGoal_].x - pose.x, goals_[nextGoal_].y - pose.y) <= parameters_.cycle.waypointTolerance_m) {
    ++nextGoal_;
    goalsChanged_ = true;
  }
}

void NavigationCycle::planPath() {
  if (global_) global_->update(record_.mapFromRobot, scans_, {});
  record_.path.clear();
  record_.replanned = true;
  goalsChanged_ = false;
  plannedAt_s_ = record_.time_s;
  TPoint2D from{record_.mapFromRobot.x, record_.mapFromRobot.y};
  for (std::size_t i = nextGoal_; i < goals_.size(); ++i) {
    const PathResult leg = globalPlanner_.plan(planningCosts(), from, withinGlobalMap({goals_[i].x, goals_[i].y}));
    record_.pathStatus = leg.status;
    if (leg.status != PathResult::Status::Found) {
      record_.path.clear();
      return;
    }
    record_.path.insert(record_.path.end(), leg.points.begin(), leg.points.end());
    from = record_.path.back();
  }
}

TPoint2D NavigationCycle::withinGlobalMap(const TPoint2D& goal) const {
  const CostGrid& grid = planningCosts();
  if (global_ || grid.bounds().contains(grid.cellX(goal.x), grid.cellY(goal.y))) return goal;
  const double side = std::min(parameters_.costmap.width_m, parameters_.costmap.height_m);
  const double margin = 0.5 * side - 2.0 * grid.getResolution();
  const TPoint2D robot{record_.mapFromRobot.x, record_.mapFromRobot.y}, way = goal - robot;
  return robot + way * (margin / std::max(std::abs(way.x), std::abs(way.y)));
}

}  // namespace bslnav
