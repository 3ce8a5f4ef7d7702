#pragma once

#include <bslnav/costmap/CostGrid.h>
#include <bslnav/navigation/Motion.h>
#include <bslnav/planning/FootprintCover.h>
#include <bslnav/planning/RobotLimits.h>
#include <bslnav/planning/Rollout.h>

#include <optional>

namespace bslnav {

/** The motions that take no local planner: braking, turning on the spot, creeping along the path,
 * backing off from obstacles and out of people's way. Those that move the robot are tested against
 * the costs first. */
class Maneuvers {
 public:
  Maneuvers(const RobotLimits& limits, const FootprintCover& footprint, double controlPeriod_s)
      : limits_(limits), footprint_(footprint), controlPeriod_s_(controlPeriod_s) {}

  mrpt::math::TTwist2D braking(const MotionInput& input) const {
    return brake(input.commandBase, limits_, controlPeriod_s_);
  }

  /** Whether the robot stands before it touches an obstacle if it is told this now and to brake
   * from the next period on, whether the base follows at once or as late as the limits say. True,
   * too, where it is nearer than its radius by the cells already: it has to get away. */
  bool canStopAfter(const mrpt::math::TTwist2D& command, const MotionInput& input,
                    const CostGrid& costs) const;

  /** Turns on the spot by an angle; blocked (and braking) where there is no room to. */
  Motion rotate(MotionMode mode, double error_rad, const MotionInput& input,
                const CostGrid& costs) const;

  /** Keeps to the path, at the fastest admissible speed up to Guard::kWorthwhile_mps, and at least
   * creeping: over the way of a few seconds, creeping candidates all but tie, and standing with
   * them. Blocked where it comes nearer to an obstacle without room.
   *  @param input with a path and a guard */
  Motion creep(const MotionInput& input, const CostGrid& costs) const;

  /** Drives straight back out of the way of people who walk; nullopt unless that leaves them more
   * room than what was planned.
   *  @param least c_mov of that
   *  @param input with movers */
  std::optional<Motion> makeWay(double least, const MotionInput& input,
                                const CostGrid& costs) const;

  /** Which way to back off: −1 backwards, if that leads away from obstacles, else 1 forwards;
   * never nearer to one than now, unless there is room; 0 where neither can be done. */
  double wayOff(const MotionInput& input, const CostGrid& costs) const;

 private:
  bool isStoppingFree(mrpt::math::TTwist2D twist, RolloutSetup setup, const CostGrid& costs) const;
  double creepSpeed_mps(double turn_radps, const MotionInput& input) const;
  bool roomToTurn(double angle_rad, const MotionInput& input, const CostGrid& costs) const;
  bool isFree(double forward_m, double left_rad, const MotionInput& input,
              const CostGrid& costs) const;

  RobotLimits limits_;
  FootprintCover footprint_;
  double controlPeriod_s_;
};

}  // namespace bslnav
