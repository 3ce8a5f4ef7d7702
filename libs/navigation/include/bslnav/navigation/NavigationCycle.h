#pragma once

#include <bslnav/blindspot/DepthClusterDetector.h>
#include <bslnav/navigation/CycleRecord.h>
#include <bslnav/navigation/DepthCameras.h>
#include <bslnav/navigation/NavigationParameters.h>
#include <bslnav/navigation/SensorFrame.h>
#include <bslnav/navigation/SensorWatch.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bslnav {

/** One control cycle: what the robot senses → blind spots → costs → path → command, with a record
 * of all of it.
 *
 * The same object serves simulator, hardware and rawlogs and does not know which. Given the same
 * frames, parameters and goals it returns the same bits (but for the stage times). Nothing in the
 * steady cycle allocates, except for a new path. */
class NavigationCycle {
 public:
  /** @param map static map, or null to plan on what the sensors have seen */
  NavigationCycle(const NavigationParameters& parameters,
                  const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map);

  /** Drives through these poses, map frame; the robot stops at the last one and takes up its
   * heading. */
  void setGoals(std::vector<mrpt::math::TPose2D> goals);

  /** A sensor that must deliver: the robot does not move before it has, nor when it falls silent.
   * Sensors that are not announced are watched from their first measurement on. */
  void expectSensor(SensorKind kind, const std::string& label) { sensors_.expect(kind, label); }

  /** Runs one cycle. The record is valid until the next call. */
  const CycleRecord& step(const SensorFrame& frame);

  /** The pipeline from depth to blind spots, as it was in the last cycle with depth. */
  const DepthClusterDetector& depthClusters() const { return depthClusters_; }
  /** The depth images that it was made of, in the robot frame of that cycle; empty without. */
  const std::vector<const DepthFrame*>& depthFrames() const { return depthCameras_.frames(); }
  const CostGrid& localCosts() const { return local_.costs(); }
  /** What the global planner plans on: the whole map, or without a map the local costs without
   * blind spots. */
  const CostGrid& planningCosts() const {
    return global_ ? global_->costs() : local_.costsWithoutBlindSpots();
  }

 private:
  mrpt::math::TTwist2D commandBase(const mrpt::math::TTwist2D& measured) const;
  CycleRecord::Health takeOver(const SensorFrame& frame);
  bool takeOverScans(const SensorFrame& frame);
  void takeOverDepth(const SensorFrame& frame);
  void resizeScans(std::size_t count);
  void findBlindSpots();
  const std::vector<BlindSpot>* newBlindSpots();
  void advanceWaypoint();
  bool needsPath() const;
  void planPath();
  mrpt::math::TPoint2D withinGlobalMap(const mrpt::math::TPoint2D& goal) const;

  NavigationParameters parameters_;
  LayeredCostmap local_;
  std::optional<LayeredCostmap> global_;  // only with a map
  ScanJumpDetector scanJumps_;
  DepthClusterDetector depthClusters_;
  DepthCameras depthCameras_;
  GlobalPlanner globalPlanner_;
  MotionPlanner motionPlanner_;

  std::vector<mrpt::math::TPose2D> goals_;
  std::size_t nextGoal_ = 0;
  bool goalsChanged_ = false;
  bool pathCutShort_ = false;  // it ends at the edge of the local map, on the way to the next goal
  double plannedAt_s_ = 0.0;
  SensorWatch sensors_;
  MotionHistory motion_;
  std::vector<PlanarScan> scans_, spareScans_;  // spare: buffers of a cycle that had more scans
  CycleRecord record_;
};

}  // namespace bslnav
