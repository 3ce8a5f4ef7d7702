#include <bslnav/costmap/CameraCover.h>
#include <bslnav/costmap/InflationLayer.h>
#include <bslnav/navigation/Surroundings.h>
#include <mrpt/core/Clock.h>
#include <mrpt/system/CTicTac.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

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

Surroundings::Surroundings(const NavigationParameters& parameters,
                           const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map)
    : parameters_(parameters),
      local_(parameters.costmap, parameters.footprint, map, Extent::Rolling),
      scanJumps_(parameters.scanJumps),
      depthClusters_(parameters.depthClusters),
      depthCameras_(parameters.depth.obstacles, parameters.personVisibility) {
  if (parameters.guard.enabled)
    people_.emplace(parameters.hiddenPeople, parameters.seenPeople,
                    parameters.footprint.circumscribedRadius_m(), map, parameters.costmap.map);
  if (map) global_.emplace(parameters.costmap, parameters.footprint, map, Extent::WholeMap);
  parameters_.dangerZone.deceleration_mps2 = parameters_.limits.deceleration_mps2;
}

FootprintCover Surroundings::footprintCover() const {
  const double resolution_m = parameters_.costmap.resolution_m;
  return FootprintCover(
      parameters_.footprint, resolution_m,
      InflationLayer(parameters_.costmap.inflation, local_.inscribedRadius_m(), resolution_m));
}

void Surroundings::update(const SensorFrame& frame, CycleRecord& record) {
  mrpt::system::CTicTac stage;
  stage.Tic();
  record.health = takeOver(frame, record);
  record.times = {};
  if (record.health != CycleRecord::Health::Ok) {
    record.blindSpots.clear();  // they were relative to a robot that has moved on
    return;
  }
  findBlindSpots(record);
  record.times.blindSpots_s = seconds(stage);
  const auto& depthScans = depthCameras_.newScans();
  local_.update(record.mapFromRobot, scans_, record.dangerZones, depthScans);
  if (global_) global_->update(record.mapFromRobot, scans_, {}, depthScans);
  record.times.costmap_s = seconds(stage);
  if (people_) findPeople(frame, record, depthScans);
  record.times.people_s = seconds(stage);
}

void Surroundings::findPeople(const SensorFrame& frame, const CycleRecord& record,
                              const std::vector<PlanarScan>& depthScans) {
  double oldest_s = std::min(frame.time_s, depthCameras_.oldestNew_s().value_or(frame.time_s));
  for (const auto& scan : frame.scans)
    oldest_s = std::min(oldest_s, mrpt::Clock::toDouble(scan->timestamp) - frame.startTime_s);
  people_->update({scans_, depthCameras_.newPersonViews(), depthScans}, oldest_s,
                  record.mapFromRobot, parameters_.guard.personSpeed_mps);
}

CycleRecord::Health Surroundings::takeOver(const SensorFrame& frame, CycleRecord& record) {
  record.time_s = frame.time_s;
  record.mapFromRobot = frame.mapFromRobot;
  record.twist = frame.twist;
  record.sensorProblem.clear();
  if (frame.afterGap) motion_.clear();
  if (isFinite(frame.odometry)) motion_.add(frame.time_s, frame.odometry);
  const bool blind = takeOverScans(frame, record);
  takeOverDepth(frame, record);
  if (!isFinite(frame.mapFromRobot) || !isFinite(frame.twist)) return CycleRecord::Health::BadPose;
  if (blind) return CycleRecord::Health::NoBeams;
  // Between two scans of a slow sensor the robot goes on with what it knows, until that is stale.
  if (sensors_.oldestAge_s(frame.time_s) <= parameters_.cycle.sensorMaxAge_s)
    return CycleRecord::Health::Ok;
  record.sensorProblem = sensors_.problemOfOldest();
  return CycleRecord::Health::StaleSensor;
}

/** Returns whether a scan has no usable beam at all. */
bool Surroundings::takeOverScans(const SensorFrame& frame, CycleRecord& record) {
  record.beams = record.droppedBeams = 0;
  resizeScans(frame.scans.size());
  bool blind = false;
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    const double stamp_s = mrpt::Clock::toDouble(frame.scans[i]->timestamp) - frame.startTime_s;
    scans_[i].assign(*frame.scans[i], parameters_.cycle.sensorMaxRange_m,
                     motion_.nowFromThen(stamp_s));
    record.beams += scans_[i].size();
    record.droppedBeams += scans_[i].dropped();
    if (scans_[i].dropped() == scans_[i].size())
      blind = true;
    else
      sensors_.heard(SensorKind::Laser, frame.scans[i]->sensorLabel, stamp_s, frame.time_s);
  }
  return blind;
}

/** A camera whose images say nothing usable is not heard, and so becomes stale; unless it is too
 * near to what it looks at. */
void Surroundings::takeOverDepth(const SensorFrame& frame, CycleRecord& record) {
  record.depthFrames = record.droppedDepthFrames = 0;
  depthCameras_.beginCycle();
  if (!parameters_.depth.enabled) return;
  for (const auto& image : frame.depth) {
    const double stamp_s = mrpt::Clock::toDouble(image->timestamp) - frame.startTime_s;
    const DepthFrame& taken = depthCameras_.add(image, stamp_s, motion_);
    const bool isUsable = taken.status() == DepthFrame::Status::Ok;
    ++record.depthFrames;
    if (!isUsable) ++record.droppedDepthFrames;
    if (isUsable || isTooNear(taken)) {
      sensors_.heard(SensorKind::Camera, image->sensorLabel, stamp_s, frame.time_s);
      continue;
    }
    record.sensorProblem = "depth camera '" + image->sensorLabel + "': " + describe(taken);
    sensors_.refused(SensorKind::Camera, image->sensorLabel, record.sensorProblem);
  }
}

/** Whether a camera sees no depth because of what the lasers meet right before it. */
bool Surroundings::isTooNear(const DepthFrame& frame) const {
  return frame.status() == DepthFrame::Status::NoDepth &&
         isViewCovered(frame, scans_, parameters_.depth.blindWithin_m);
}

void Surroundings::resizeScans(std::size_t count) {
  for (; scans_.size() > count; scans_.pop_back()) spareScans_.push_back(std::move(scans_.back()));
  for (; scans_.size() < count && !spareScans_.empty(); spareScans_.pop_back())
    scans_.push_back(std::move(spareScans_.back()));
  scans_.resize(count);
}

/** Of the sensors' news in this cycle; null when there are none. */
const std::vector<BlindSpot>* Surroundings::newBlindSpots(double time_s) {
  switch (parameters_.blindSpots.source) {
    case BlindSpotSource::ScanJumps:
      return scans_.empty() ? nullptr : &scanJumps_.detect(scans_);
    case BlindSpotSource::DepthClusters: {
      const double oldest_s = time_s - parameters_.cycle.sensorMaxAge_s;
      if (!depthCameras_.hasNew() && depthCameras_.hasSince(oldest_s)) return nullptr;
      return &depthClusters_.detect(depthCameras_.framesSince(oldest_s, motion_));
    }
    case BlindSpotSource::None:
      break;
  }
  return nullptr;
}

void Surroundings::findBlindSpots(CycleRecord& record) {
  const auto* found = newBlindSpots(record.time_s);
  if (!found) return;
  record.blindSpots = *found;
  record.dangerZones.clear();
  const double speed_mps = std::abs(speedOf(record.twist, parameters_.limits));
  for (const BlindSpot& spot : record.blindSpots)
    record.dangerZones.push_back(
        dangerZone(spot, record.mapFromRobot, speed_mps, parameters_.dangerZone));
}

}  // namespace bslnav
