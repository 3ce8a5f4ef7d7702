#pragma once

#include <bslnav/evaluation/DepthStagePage.h>
#include <bslnav/evaluation/RunTrace.h>

#include <string>
#include <vector>

namespace bslnav {

/** Gathers what a simulated run's pictures show, cycle by cycle, and draws them. */
class SimulationPictures {
 public:
  SimulationPictures(const SimulationSetup& setup,
                     std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> map);

  /** Takes in one cycle; keeps a snapshot when one of the configured times has come. */
  void observe(const SimulationMoment& moment);

  /** Writes trajectory.png, speed.png and, with snapshots, snapshots.png into a directory.
   *  @returns their paths  @throws Error (Run) when a file cannot be written */
  std::vector<std::string> save(const RunSummary& summary, const std::string& directory) const;

 private:
  const SimulationSetup& setup_;
  std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> map_;
  RunTrace trace_;
  std::vector<DepthStagePage> depthStages_;
};

}  // namespace bslnav
