#pragma once

#include <bslnav/navigation/Recovery.h>
#include <bslnav/planning/FootprintCover.h>
#include <bslnav/planning/LocalPlanner.h>
#include <bslnav/planning/RobotLimits.h>

#include <memory>
#include <string>
#include <vector>

namespace bslnav {

/** How the robot is being moved. */
enum class MotionMode : std::uint8_t {
  Idle,
  Follow,
  RotateToPath,
  StopAtGoal,
  RotateToGoal,
  BackOff,
  MakeWay,
  Arrived,
  Failed
};
/** The word for a mode in records and tables. */
const char* nameOf(MotionMode mode);

struct MotionParameters {
  double lookahead_m = 3.0;  ///< the local goal lies this far ahead on the path
  double goalTolerance_m = 0.1;
  bool alignAtGoal = true;  ///< turn to the goal's heading after arriving
  double headingTolerance_rad = 0.1;
  double rotateToPathAbove_rad =
      1.05;  ///< standing, with the path farther aside than this: turn on the spot first

  void describe(ConfigSection& section);
};

/** What the robot is to do in one cycle, and what was considered. */
struct Motion {
  MotionMode mode = MotionMode::Idle;
  mrpt::math::TTwist2D command;    ///< within the limits
  bool blocked = false;            ///< no admissible candidate, or no room to turn
  bool planned = false;            ///< whether `dwa` belongs to this cycle
  mrpt::math::TPoint2D localGoal;  ///< map frame
};

/** Moves along a path to a goal: a local planner, with what it cannot do by itself (turning on the
 * spot to the path and to the final heading, stopping at the goal, recovery). */
class MotionPlanner {
 public:
  MotionPlanner(const MotionParameters& parameters, const RecoveryParameters& recovery,
                std::unique_ptr<LocalPlanner> planner, const RobotLimits& limits,
                const FootprintCover& footprint, double controlPeriod_s);

  struct Input {
    double time_s;
    mrpt::math::TPose2D mapFromRobot;
    mrpt::math::TTwist2D twist;                     ///< measured
    mrpt::math::TTwist2D commandBase;               ///< what the next command starts from
    const std::vector<mrpt::math::TPoint2D>& path;  ///< empty: none was found
    mrpt::math::TPose2D goal;      ///< where the path leads; its heading is taken up on arrival
    double passWithin_m = 0.0;     ///< above 0: a waypoint, passed this near without stopping
    const Guard* guard = nullptr;  ///< what it refuses is no candidate
    const MoverForecast* movers = nullptr;  ///< whom not to be in the way of
    bool looksBehind = false;               ///< whether it may drive back for them
  };

  Motion step(const Input& input, const CostGrid& costs);

  /** Whether recovery wants a new path; true for one cycle. */
  bool wantsReplan() const { return recoveryStep_ == Recovery::Step::Replan; }
  /** The local planner's result of the last cycle in which Motion::planned was true. */
  const DwaResult& dwa() const { return *dwa_; }
  /** Starts afresh: after a new goal. */
  void reset();
  /** Starts recovery's clocks afresh: after a time in which the robot was not to move. */
  void forgetProgress() { recovery_.reset(); }

 private:
  Motion follow(const Input& input, const CostGrid& costs);
  Motion plan(const Input& input, const CostGrid& costs);
  double creepSpeed_mps(double turn_radps, const Input& input) const;
  Motion creep(const Input& input, const CostGrid& costs);
  void makeWay(const Input& input, const CostGrid& costs, Motion& motion) const;
  Motion rotate(MotionMode mode, double error_rad, const Input& input, const CostGrid& costs);
  Motion backOff(const Input& input, const CostGrid& costs);
  Motion arrive(const Input& input, const CostGrid& costs);
  bool roomToTurn(double angle_rad, const Input& input, const CostGrid& costs) const;
  bool isFree(double forward_m, double left_rad, const Input& input, const CostGrid& costs) const;

  MotionParameters parameters_;
  RecoveryParameters recoveryParameters_;
  RobotLimits limits_;
  FootprintCover footprint_;
  double controlPeriod_s_;
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
