#include <bslnav/navigation/InPlaceRotation.h>
#include <bslnav/navigation/MotionPlanner.h>
#include <bslnav/planning/PathDistance.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>

namespace bslnav {

using mrpt::math::TPoint2D;

namespace {

constexpr double kTurnToCreep_rad = 0.35;
constexpr double kInTheWay = 1.0;  // c_mov above which standing is

const Candidate& best(const DwaResult& dwa) {
  return dwa.candidates[static_cast<std::size_t>(dwa.best)];
}

}  // namespace

void MotionParameters::describe(ConfigSection& section) {
  section.number("lookahead_m", lookahead_m, kPositive, "m",
                 "the local goal lies this far ahead on the path");
  section.number("goal_tolerance_m", goalTolerance_m, {0.01, 10.0}, "m",
                 "this near is at the goal");
  section.flag("align_at_goal", alignAtGoal,
               "whether to turn to the goal's heading after arriving");
  section.angle("heading_tolerance_deg", headingTolerance_rad, {0.5, 180.0},
                "this near is the wanted heading");
  section.angle(
      "rotate_to_path_above_deg", rotateToPathAbove_rad, {10.0, 180.0},
      "standing, with the path farther aside than this, the robot turns on the spot first");
}

MotionPlanner::MotionPlanner(const MotionParameters& parameters, const RecoveryParameters& recovery,
                             std::unique_ptr<LocalPlanner> planner, const RobotLimits& limits,
                             const FootprintCover& footprint, double controlPeriod_s)
    : parameters_(parameters),
      recoveryParameters_(recovery),
      limits_(limits),
      controlPeriod_s_(controlPeriod_s),
      maneuvers_(limits, footprint, controlPeriod_s),
      planner_(std::move(planner)),
      recovery_(recovery) {}

void MotionPlanner::reset() {
  planner_->reset();
  recovery_.reset();
  recoveryStep_ = Recovery::Step::None;
  blocked_ = stepDone_ = stopping_ = atGoal_ = turning_ = backingOff_ = false;
}

Motion MotionPlanner::step(const MotionInput& input, const CostGrid& costs) {
  const TPoint2D robot{input.mapFromRobot.x, input.mapFromRobot.y};
  const TPoint2D goal =
      input.path.empty() ? TPoint2D{input.goal.x, input.goal.y} : input.path.back();
  const bool stops = input.passWithin_m == 0.0;
  const bool near = stops && (goal - robot).norm() <= parameters_.goalTolerance_m;
  if (isStanding(
          input.twist)) {  // only then it shows whether the robot stopped within the tolerance
    atGoal_ = atGoal_ || near;
    stopping_ = false;
  }
  stopping_ = stopping_ || near;
  if (atGoal_ || stopping_) return arrive(input, costs);

  recoveryStep_ = recovery_.update(input.time_s, input.mapFromRobot, blocked_, stepDone_);
  stepDone_ = false;
  backingOff_ = backingOff_ && recoveryStep_ == Recovery::Step::BackOff;
  Motion motion;
  switch (recoveryStep_) {
    case Recovery::Step::GiveUp:
      motion.mode = MotionMode::Failed;
      motion.command = maneuvers_.braking(input);
      break;
    case Recovery::Step::BackOff:
      motion = backOff(input, costs);
      break;
    case Recovery::Step::RotateToPath:
      turning_ = true;
      motion = follow(input, costs);
      stepDone_ = !turning_ || motion.blocked;
      break;
    case Recovery::Step::Replan:
      stepDone_ = true;
      [[fallthrough]];
    case Recovery::Step::None:
      motion = follow(input, costs);
  }
  blocked_ = motion.blocked;
  return motion;
}

Motion MotionPlanner::arrive(const MotionInput& input, const CostGrid& costs) {
  Motion motion;
  const double error = mrpt::math::wrapToPi(input.goal.phi - input.mapFromRobot.phi);
  if (atGoal_ && parameters_.alignAtGoal && std::abs(error) > parameters_.headingTolerance_rad) {
    motion = maneuvers_.rotate(MotionMode::RotateToGoal, error, input, costs);
    if (!motion.blocked) return motion;  // without room to turn, being there has to do
    motion.blocked = false;
  }
  const bool arrived = atGoal_ && isStanding(input.twist);
  motion.mode = arrived ? MotionMode::Arrived : MotionMode::StopAtGoal;
  motion.command = maneuvers_.braking(input);
  return motion;
}

Motion MotionPlanner::follow(const MotionInput& input, const CostGrid& costs) {
  Motion motion;
  motion.mode = MotionMode::Follow;
  if (input.path.empty()) {
    motion.blocked = true;
    turning_ = false;
    motion.command = maneuvers_.braking(input);
    return motion;
  }
  const TPoint2D robot{input.mapFromRobot.x, input.mapFromRobot.y};
  const TPoint2D localGoal = pointAhead(input.path, robot, parameters_.lookahead_m);
  const double bearing = bearingTo(input.mapFromRobot, pointAhead(input.path, robot, 0.5));
  // Who is about to be met goes on planning, and neither turns nor creeps.
  const bool inTheWay = input.movers && input.movers->cost({}) > kInTheWay;
  const bool creeps =
      !inTheWay && input.guard && (input.guard->mayCreep() || input.guard->isBesideStanding());
  const double turnAbove = creeps ? kTurnToCreep_rad : parameters_.rotateToPathAbove_rad;
  if (isStanding(input.twist) && std::abs(bearing) > turnAbove) turning_ = true;
  if (std::abs(bearing) < 0.2 || inTheWay) turning_ = false;
  if (turning_) {
    motion = maneuvers_.rotate(MotionMode::RotateToPath, bearing, input, costs);
    motion.localGoal = localGoal;
    if (!motion.blocked) return motion;
    turning_ = false;
  }
  if (creeps) return creep(input, costs);
  motion = plan(input, costs);
  return inTheWay ? makeWay(input, costs, motion) : motion;
}

/** Out of the way of people who walk, or as planned if nothing is better. */
Motion MotionPlanner::makeWay(const MotionInput& input, const CostGrid& costs,
                              const Motion& planned) const {
  const double least = dwa_->best < 0 ? input.movers->cost({}) : best(*dwa_).terms.movers;
  std::optional<Motion> back = maneuvers_.makeWay(least, input, costs);
  if (!back) return planned;
  back->planned = true;
  back->localGoal = planned.localGoal;
  return *back;
}

Motion MotionPlanner::plan(const MotionInput& input, const CostGrid& costs) {
  const TPoint2D robot{input.mapFromRobot.x, input.mapFromRobot.y};
  const TPoint2D localGoal = pointAhead(input.path, robot, parameters_.lookahead_m);
  const bool stops = input.passWithin_m == 0.0;
  const bool atEnd = (localGoal - input.path.back()).norm() < 1e-9;
  const double tolerance_m = stops ? parameters_.goalTolerance_m : input.passWithin_m;
  dwa_ = &planner_->plan(
      {input.mapFromRobot, input.commandBase, input.path, localGoal, atEnd ? tolerance_m : 0.0,
       atEnd && stops, input.guard, input.movers, input.maxSpeed_mps},
      costs);
  Motion motion;
  motion.mode = MotionMode::Follow;
  motion.planned = true;
  motion.localGoal = localGoal;
  motion.command = dwa_->command;
  motion.blocked = dwa_->status == DwaResult::Status::NoAdmissible;
  if (input.guard) keepRoomToStop(input, costs, motion);
  return motion;
}

/** Brakes where the way from this velocity to the planned one is not free, as candidates are. The
 * paper's methods, which have no guard, drive as they are written. */
void MotionPlanner::keepRoomToStop(const MotionInput& input, const CostGrid& costs,
                                   Motion& motion) const {
  const auto braking = maneuvers_.braking(input);
  if (motion.command == braking || maneuvers_.canStopAfter(motion.command, input, costs)) return;
  motion.command = braking;
  motion.blocked = true;
}

/** Creeps along the path: slow, but not stuck. */
Motion MotionPlanner::creep(const MotionInput& input, const CostGrid& costs) {
  const TPoint2D robot{input.mapFromRobot.x, input.mapFromRobot.y};
  Motion motion = maneuvers_.creep(input, costs);
  motion.localGoal = pointAhead(input.path, robot, parameters_.lookahead_m);
  if (!motion.blocked) recovery_.reset();
  return motion;
}

Motion MotionPlanner::backOff(const MotionInput& input, const CostGrid& costs) {
  if (!backingOff_) backOffFrom_ = input.mapFromRobot;
  backingOff_ = true;
  const auto& pose = input.mapFromRobot;
  const double moved = std::hypot(pose.x - backOffFrom_.x, pose.y - backOffFrom_.y);
  const double direction = maneuvers_.wayOff(input, costs);
  Motion motion;
  motion.mode = MotionMode::BackOff;
  motion.command = limited({direction * recoveryParameters_.backOffSpeed_mps, 0.0, 0.0},
                           input.commandBase, limits_, controlPeriod_s_);
  stepDone_ = direction == 0.0 || moved >= recoveryParameters_.backOffDistance_m;
  if (stepDone_) {
    backingOff_ = false;
    motion.command = maneuvers_.braking(input);
  }
  return motion;
}

}  // namespace bslnav
