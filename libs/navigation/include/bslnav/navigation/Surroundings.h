#pragma once

#include <bslnav/blindspot/DepthClusterDetector.h>
#include <bslnav/navigation/CycleRecord.h>
#include <bslnav/navigation/DepthCameras.h>
#include <bslnav/navigation/NavigationParameters.h>
#include <bslnav/navigation/People.h>
#include <bslnav/navigation/SensorFrame.h>
#include <bslnav/navigation/SensorWatch.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bslnav {

/** The first half of a control cycle: what the robot senses → blind spots → costs. */
class Surroundings {
 public:
  /** @param map static map, or null to plan on what the sensors have seen */
  Surroundings(const NavigationParameters& parameters,
               const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map);

  /** A sensor that must deliver: not healthy before it has, nor when it falls silent. Sensors that
   * are not announced are watched from their first measurement on. */
  void expectSensor(SensorKind kind, const std::string& label) { sensors_.expect(kind, label); }

  /** Takes over a frame and fills the record's part of it: all before the path. Costs and blind
   * spots are renewed only if the record's health is Ok. */
  void update(const SensorFrame& frame, CycleRecord& record);

  /** The depth images that blind spots were found in, in the robot frame of that cycle; empty
   * without. */
  const std::vector<const DepthFrame*>& depthFrames() const { return depthCameras_.frames(); }
  /** The last frame's scans, in the robot frame of that cycle. */
  const std::vector<PlanarScan>& scans() const { return scans_; }
  /** Who may step in the robot's way; null unless the guard is enabled. */
  const People* people() const { return people_ ? &*people_ : nullptr; }
  const CostGrid& localCosts() const { return local_.costs(); }
  /** What the global planner plans on: the whole map, or without a map the local costs without
   * blind spots. */
  const CostGrid& planningCosts() const {
    return global_ ? global_->costs() : local_.costsWithoutBlindSpots();
  }
  bool hasMap() const { return global_.has_value(); }
  /** The footprint for rollouts over these costs. */
  FootprintCover footprintCover() const;

 private:
  CycleRecord::Health takeOver(const SensorFrame& frame, CycleRecord& record);
  bool takeOverScans(const SensorFrame& frame, CycleRecord& record);
  void takeOverDepth(const SensorFrame& frame, CycleRecord& record);
  bool isTooNear(const DepthFrame& frame) const;
  void resizeScans(std::size_t count);
  void findPeople(const SensorFrame& frame, const CycleRecord& record,
                  const std::vector<PlanarScan>& depthScans);
  void findBlindSpots(CycleRecord& record);
  const std::vector<BlindSpot>* newBlindSpots(double time_s);

  NavigationParameters parameters_;
  LayeredCostmap local_;
  std::optional<LayeredCostmap> global_;  // only with a map
  std::optional<People> people_;          // only with the guard
  ScanJumpDetector scanJumps_;
  DepthClusterDetector depthClusters_;
  DepthCameras depthCameras_;
  SensorWatch sensors_;
  MotionHistory motion_;
  std::vector<PlanarScan> scans_, spareScans_;  // spare: buffers of a cycle that had more scans
};

}  // namespace bslnav
