#pragma once

#include <bslnav/costmap/CostGrid.h>
#include <bslnav/planning/FootprintCover.h>
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>

#include <cstdint>
#include <vector>

namespace bslnav {

/** Where a rollout ended and what it met on the way. */
struct RolloutOutcome {
  enum class End : std::uint8_t {
    Horizon,   ///< driven to the end of the horizon
    Goal,      ///< passes the goal within the tolerance; ends where it is nearest to it
    Obstacle,  ///< the centre meets an inscribed or lethal cell, or the outline a lethal one
    Unknown    ///< the centre meets an unknown cell or leaves the map
  };
  mrpt::math::TPoint2D endPoint;  ///< map frame [m]
  Cost highestCost = kFreeCost;   ///< along the robot's centre, without the start
  int steps = 0;
  End end = End::Horizon;

  bool blocked() const { return end == End::Obstacle || end == End::Unknown; }
};

/** How rollouts of one control cycle are made: everything but the velocity. */
struct RolloutSetup {
  mrpt::math::TPose2D start;  ///< map frame
  double horizon_s = 4.0;     ///< T_pre
  double step_s =
      0.1;  ///< longest time step; fast candidates step finer, so that no cell is passed over
  bool allowUnknown = false;
  double outlineReach_m = 0.0;   ///< FootprintCover::reach_m(): corners, too, pass over no cell
  mrpt::math::TPoint2D goal;     ///< map frame
  double goalTolerance_m = 0.0;  ///< 0: the goal does not end a rollout
};

/** Drives a constant velocity (robot frame) from the start along its exact arc until the horizon,
 * the goal or an obstacle (paper III-B). */
RolloutOutcome rollOut(const mrpt::math::TTwist2D& twist, const RolloutSetup& setup,
                       const CostGrid& costs, const FootprintCover& footprint);
/** The same without lateral motion. */
inline RolloutOutcome rollOut(double v_mps, double w_radps, const RolloutSetup& setup,
                              const CostGrid& costs, const FootprintCover& footprint) {
  return rollOut({v_mps, 0.0, w_radps}, setup, costs, footprint);
}

/** A path in the robot's frame as poses from the start on, nowhere farther apart than a cell of the
 * grid that it is rolled out on; arrays of equal length. */
struct SampledPath {
  std::vector<float> x_m, y_m, cosine, sine;  ///< of the heading
  std::vector<float> distance_m;              ///< driven so far; from 0 on, growing

  void clear();
  void add(const mrpt::math::TPose2D& pose, double drivenSoFar_m);
  std::size_t size() const { return x_m.size(); }
};

/** Drives along a path until `reach_m` of it, its end, the goal or an obstacle. The path must have
 * two poses at least. */
RolloutOutcome rollOut(const SampledPath& path, double reach_m, const RolloutSetup& setup,
                       const CostGrid& costs, const FootprintCover& footprint);

/** The poses of the rollout of a constant velocity, for pictures: start first. */
std::vector<mrpt::math::TPose2D> rolloutPoses(const mrpt::math::TTwist2D& twist,
                                              const RolloutSetup& setup, int steps,
                                              const CostGrid& costs);

}  // namespace bslnav
