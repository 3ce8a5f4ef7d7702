#pragma once

#include <bslnav/navigation/Maneuvers.h>
#include <bslnav/navigation/Motion.h>
#include <bslnav/navigation/Recovery.h>
#include <bslnav/planning/LocalPlanner.h>
#include <bslnav/planning/RobotLimits.h>

#include <memory>
#include <vector>

namespace bslnav {

struct MotionParameters {
  double lookahead_m = 3.0;  ///< the local goal lies this far ahead on the path
  double goalTolerance_m = 0.1;
  bool alignAtGoal = true;  ///< turn to the goal's heading after arriving
  double headingTolerance_rad = 0.1;
  double rotateToPathAbove_rad =
      1.05;  ///< standing, with the path farther aside than this: turn on the spot first

  void describe(ConfigSection& section);
};

/** Moves along a path to a goal: a local planner, with what it cannot do by itself (turning on the
 * spot to the path and to the final heading, stopping at the goal, recovery). */
class MotionPlanner {
 public:
  MotionPlanner(const MotionParameters& parameters, const RecoveryParameters& recovery,
                std::unique_ptr<LocalPlanner> planner, const RobotLimits& limits,
                const FootprintCover& footprint, double controlPeriod_s);

  Motion step(const MotionInput& input, const CostGrid& costs);

  /** Whether recovery wants a new path; true for one cycle. */
  bool wantsReplan() const { return recoveryStep_ == Recovery::Step::Replan; }
  /** The local planner's result of the last cycle in which Motion::planned was true. */
  const DwaResult& dwa() const { return *dwa_; }
  /** Starts afresh: after a new goal. */
  void reset();
  /** Starts recovery's clocks afresh: after a time in which the robot was not to move. */
  void forgetProgress() { recovery_.reset(); }

 private:
  Motion follow(const MotionInput& input, const CostGrid& costs);
  Motion plan(const MotionInput& input, const CostGrid& costs);
  void keepRoomToStop(const MotionInput& input, const CostGrid& costs, Motion& motion) const;
  Motion makeWay(const MotionInput& input, const CostGrid& costs, const Motion& planned) const;
  Motion creep(const MotionInput& input, const CostGrid& costs);
  Motion backOff(const MotionInput& input, const CostGrid& costs);
  Motion arrive(const MotionInput& input, const CostGrid& costs);

  MotionParameters parameters_;
  RecoveryParameters recoveryParameters_;
  RobotLimits limits_;
  double controlPeriod_s_;
  Maneuvers maneuvers_;
  std::unique_ptr<LocalPlanner> planner_;
  Recovery recovery_;
  Recovery::Step recoveryStep_ = Recovery::Step::None;
  bool blocked_ = false, stepDone_ = false, turning_ = false;
  bool stopping_ = false, atGoal_ = false;  // within the tolerance: braking, and standing
  mrpt::math::TPose2D backOffFrom_;
  bool backingOff_ = false;
  const DwaResult* dwa_ = nullptr;
};

}  // namespace bslnav
