#pragma once

#include <bslnav/evaluation/CycleSnapshots.h>
#include <bslnav/evaluation/SimulationRun.h>
#include <bslnav/pictures/MapPicture.h>

#include <string>
#include <vector>

namespace bslnav {

/** Gathers what a simulated run's pictures show, cycle by cycle, and draws them. */
class SimulationPictures {
 public:
  SimulationPictures(const SimulationSetup& setup,
                     std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> map);

  /** Takes in one cycle; draws a cost map snapshot when one of the configured times has come. */
  void observe(const SimulationMoment& moment);

  /** Writes trajectory.png, speed.png and, with snapshots, snapshots.png into a directory.
   *  @returns their paths  @throws Error (Run) when a file cannot be written */
  std::vector<std::string> save(const RunSummary& summary, const std::string& directory) const;

 private:
  void drawWorld(MapPicture& picture) const;
  MapPicture trajectoryPicture(const RunSummary& summary) const;

  const SimulationSetup& setup_;
  std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> map_;
  MapBounds bounds_;
  std::vector<double> time_s_, speed_mps_, command_mps_, clearance_m_;
  std::vector<mrpt::math::TPoint2D> positions_;
  std::vector<std::vector<mrpt::math::TPoint2D>> people_;
  std::vector<mrpt::math::TPoint2D> firstPath_;
  mrpt::math::TPose2D lastPose_;
  std::vector<SimulationState::Person> lastPeople_;
  std::size_t nextSnapshot_ = 0;
  CycleSnapshots snapshots_;
};

}  // namespace bslnav
