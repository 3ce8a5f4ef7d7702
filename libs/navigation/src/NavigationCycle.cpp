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

bool isFinite(const mrpt::math::TPose2D& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.phi);
}

bool isFinite(const mrpt::math::TTwist2D& t) {
  return std::isfinite(t.vx) && std::isfinite(t.vy) && std::isfinite(t.omega);
}

}  // namespace

NavigationCycle::NavigationCycle(const NavigationParameters& parameters,
                                 const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map)
    : parameters_(parameters),
      local_(parameters.costmap, parameters.footprint, map, Extent::Rolling),
      scanJumps_(parameters.scanJumps),
      depthClusters_(parameters.depthClusters),
      depthCameras_(parameters.depth.obstacles),
      globalPlanner_(parameters.globalPlanner),
      motionPlanner_(
          parameters.motion, parameters.recovery, parameters.dwa, parameters.limits,
          FootprintCover(parameters.footprint, parameters.costmap.resolution_m,
                         InflationLayer(parameters.costmap.inflation, local_.inscribedRadius_m(),
                                        parameters.costmap.resolution_m)),
          parameters.cycle.period_s) {
  if (map) global_.emplace(parameters.costmap, parameters.footprint, map, Extent::WholeMap);
  record_.index = -1;
  parameters_.dangerZone.deceleration_mps2 = parameters_.limits.deceleration_mps2;
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
  const auto base = commandBase(frame.twist);
  const auto stop = brake(base, parameters_.limits, parameters_.cycle.period_s);
  record_.motion = {};
  record_.motion.command = stop;
  record_.replanned = false;
  if (record_.health != CycleRecord::Health::Ok) {
    record_.blindSpots.clear();  // they were relative to a robot that has moved on
    motionPlanner_.forgetProgress();
    record_.times.total_s = whole.Tac();
    return record_;
  }
  findBlindSpots();
  record_.times.blindSpots_s = seconds(stage);

  const auto& depthScans = depthCameras_.newScans();
  local_.update(record_.mapFromRobot, scans_, record_.dangerZones, depthScans);
  if (global_) global_->update(record_.mapFromRobot, scans_, {}, depthScans);
  record_.times.costmap_s = seconds(stage);

  if (goals_.empty()) {
    record_.path.clear();
    record_.pathStatus = PathResult::Status::Found;
    record_.times.total_s = whole.Tac();
    return record_;
  }
  advanceWaypoint();
  if (needsPath()) planPath();
  record_.times.globalPlan_s = seconds(stage);

  const bool waypoint = pathCutShort_ || nextGoal_ + 1 < goals_.size();
  record_.motion = motionPlanner_.step(
      {record_.time_s, record_.mapFromRobot, record_.twist, base, record_.path, goals_[nextGoal_],
       waypoint ? parameters_.cycle.waypointTolerance_m : 0.0},
      local_.costs());
  if (record_.motion.planned) record_.dwa = motionPlanner_.dwa();
  record_.times.motion_s = seconds(stage);
  record_.times.total_s = whole.Tac();
  return record_;
}

mrpt::math::TTwist2D NavigationCycle::commandBase(const mrpt::math::TTwist2D& measured) const {
  const auto& last = record_.motion.command;
  if (!isFinite(measured)) return last;  // then the robot is taken to do as it was told
  return record_.index == 0 ? measured : bslnav::commandBase(measured, last, parameters_.limits);
}

CycleRecord::Health NavigationCycle::takeOver(const SensorFrame& frame) {
  record_.time_s = frame.time_s;
  record_.mapFromRobot = frame.mapFromRobot;
  record_.twist = frame.twist;
  record_.sensorProblem.clear();
  if (frame.afterGap) motion_.clear();
  if (isFinite(frame.odometry)) motion_.add(frame.time_s, frame.odometry);
  const bool blind = takeOverScans(frame);
  takeOverDepth(frame);
  if (!isFinite(frame.mapFromRobot) || !isFinite(frame.twist)) return CycleRecord::Health::BadPose;
  if (blind) return CycleRecord::Health::NoBeams;
  // Between two scans of a slow sensor the robot goes on with what it knows, until that is stale.
  if (sensors_.oldestAge_s(frame.time_s) <= parameters_.cycle.sensorMaxAge_s)
    return CycleRecord::Health::Ok;
  record_.sensorProblem = sensors_.problemOfOldest();
  return CycleRecord::Health::StaleSensor;
}

/** Returns whether a scan has no usable beam at all. */
bool NavigationCycle::takeOverScans(const SensorFrame& frame) {
  record_.beams = record_.droppedBeams = 0;
  resizeScans(frame.scans.size());
  bool blind = false;
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    const double stamp_s = mrpt::Clock::toDouble(frame.scans[i]->timestamp) - frame.startTime_s;
    scans_[i].assign(*frame.scans[i], parameters_.cycle.sensorMaxRange_m,
                     motion_.nowFromThen(stamp_s));
    record_.beams += scans_[i].size();
    record_.droppedBeams += scans_[i].dropped();
    if (scans_[i].dropped() == scans_[i].size())
      blind = true;
    else
      sensors_.heard(SensorKind::Laser, frame.scans[i]->sensorLabel, stamp_s, frame.time_s);
  }
  return blind;
}

/** A camera whose images say nothing usable is not heard, and so becomes stale. */
void NavigationCycle::takeOverDepth(const SensorFrame& frame) {
  record_.depthFrames = record_.droppedDepthFrames = 0;
  depthCameras_.beginCycle();
  if (!parameters_.depth.enabled) return;
  for (const auto& image : frame.depth) {
    const double stamp_s = mrpt::Clock::toDouble(image->timestamp) - frame.startTime_s;
    const DepthFrame& taken = depthCameras_.add(image, stamp_s, motion_);
    ++record_.depthFrames;
    if (taken.status() == DepthFrame::Status::Ok) {
      sensors_.heard(SensorKind::Camera, image->sensorLabel, stamp_s, frame.time_s);
      continue;
    }
    ++record_.droppedDepthFrames;
    record_.sensorProblem = "depth camera '" + image->sensorLabel + "': " + describe(taken);
    sensors_.refused(SensorKind::Camera, image->sensorLabel, record_.sensorProblem);
  }
}

void NavigationCycle::resizeScans(std::size_t count) {
  for (; scans_.size() > count; scans_.pop_back()) spareScans_.push_back(std::move(scans_.back()));
  for (; scans_.size() < count && !spareScans_.empty(); spareScans_.pop_back())
    scans_.push_back(std::move(spareScans_.back()));
  scans_.resize(count);
}

/** Of the sensors' news in this cycle; null when there are none. */
const std::vector<BlindSpot>* NavigationCycle::newBlindSpots() {
  switch (parameters_.blindSpots.source) {
    case BlindSpotSource::ScanJumps:
      return scans_.empty() ? nullptr : &scanJumps_.detect(scans_);
    case BlindSpotSource::DepthClusters:
      if (!depthCameras_.hasNew()) return nullptr;
      return &depthClusters_.detect(
          depthCameras_.framesSince(record_.time_s - parameters_.cycle.sensorMaxAge_s, motion_));
    case BlindSpotSource::None:
      break;
  }
  return nullptr;
}

void NavigationCycle::findBlindSpots() {
  const auto* found = newBlindSpots();
  if (!found) return;
  record_.blindSpots = *found;
  record_.dangerZones.clear();
  const double speed_mps = std::abs(speedOf(record_.twist, parameters_.limits));
  for (const BlindSpot& spot : record_.blindSpots)
    record_.dangerZones.push_back(
        dangerZone(spot, record_.mapFromRobot, speed_mps, parameters_.dangerZone));
}

void NavigationCycle::advanceWaypoint() {
  const auto isNear = [this](double x, double y) {
    const auto& pose = record_.mapFromRobot;
    return std::hypot(x - pose.x, y - pose.y) <= parameters_.cycle.waypointTolerance_m;
  };
  // A waypoint in an obstacle is passed where the path ends: as near to it as one gets.
  bool passed = !goalsChanged_ && !pathCutShort_ && !record_.path.empty() &&
                isNear(record_.path.back().x, record_.path.back().y);
  for (; nextGoal_ + 1 < goals_.size() &&
         (passed || isNear(goals_[nextGoal_].x, goals_[nextGoal_].y));
       ++nextGoal_) {
    goalsChanged_ = true;
    passed = false;
  }
}

bool NavigationCycle::needsPath() const {
  const auto& pose = record_.mapFromRobot;
  const bool atCut = pathCutShort_ && !record_.path.empty() &&
                     std::hypot(record_.path.back().x - pose.x, record_.path.back().y - pose.y) <
                         parameters_.motion.lookahead_m;
  return goalsChanged_ || atCut || motionPlanner_.wantsReplan() ||
         record_.time_s - plannedAt_s_ >= parameters_.cycle.replanPeriod_s - 1e-6;
}

void NavigationCycle::planPath() {
  record_.path.clear();
  record_.replanned = true;
  goalsChanged_ = false;
  plannedAt_s_ = record_.time_s;
  const TPoint2D goal{goals_[nextGoal_].x, goals_[nextGoal_].y}, reachable = withinGlobalMap(goal);
  pathCutShort_ = (reachable - goal).norm() > 0.0;
  const PathResult path = globalPlanner_.plan(
      planningCosts(), {record_.mapFromRobot.x, record_.mapFromRobot.y}, reachable);
  record_.pathStatus = path.status;
  record_.goalMoved = path.goalMoved;
  record_.path.assign(path.points.begin(), path.points.end());
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
