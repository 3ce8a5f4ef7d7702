#pragma once

#include <bslnav/evaluation/CycleSnapshots.h>
#include <bslnav/evaluation/SimulationRun.h>
#include <bslnav/evaluation/Thinning.h>

#include <optional>
#include <vector>

namespace bslnav {

/** What the pictures of a run show, gathered cycle by cycle, of a long run thinned; map frame. */
struct RunTrace {
  std::vector<double> time_s, speed_mps, command_mps, clearance_m;
  std::vector<double> distance_m;  ///< driven so far
  std::vector<mrpt::math::TPoint2D> positions;
  std::vector<std::vector<mrpt::math::TPoint2D>> walks;  ///< a list for each person
  std::vector<mrpt::math::TPoint2D> firstPath;           ///< the first global path
  mrpt::math::TPose2D lastPose;
  std::vector<SimulationState::Person> lastPeople;
  /** For each person the cycle in which the walk began, where it did. */
  std::vector<std::optional<std::size_t>> walkStarts;
  std::vector<CycleSnapshot> snapshots;  ///< one for each instant that the run reached

  /** Takes in one cycle. @param instants_s rising times at which a snapshot is kept */
  void observe(const SimulationMoment& moment, const std::vector<double>& instants_s);

 private:
  void keep(const SimulationMoment& moment);
  void halve();

  Thinning thinning_;
  double driven_m_ = 0.0;
};

}  // namespace bslnav
