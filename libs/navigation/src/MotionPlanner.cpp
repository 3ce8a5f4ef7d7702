#include <bslnav/navigation/Clearance.h>
#include <bslnav/navigation/InPlaceRotation.h>
#include <bslnav/navigation/MotionPlanner.h>
#include <bslnav/planning/PathDistance.h>
#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>

namespace bslnav {

using mrpt::math::TPoint2D;
using mrpt::math::TTwist2D;

namespace {

constexpr double kTurnToCreep_rad = 0.35;
constexpr double kInTheWay = 1.0;         // c_mov above which standing is
constexpr double kBackingFrom_mps = 0.1;  // faster, it first brakes
constexpr double kWorthBacking = 0.02;    // less of c_mov is not
constexpr double kCreepAhead_m = 0.3;     // who creeps heads for this point of the path

}  // namespace

const char* nameOf(MotionMode mode) {
  static constexpr const char* kNames[] = {"idle",         "follow",         "rotate_to_path",
                                           "stop_at_goal", "rotate_to_goal", "back_off",
                                           "make_way",     "arrived",        "failed"};
  return kNames[static_cast<int>(mode)];
}

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
      footprint_(footprint),
      controlPeriod_s_(controlPeriod_s),
      planner_(std::move(planner)),
      recovery_(recovery) {}

void MotionPlanner::reset() {
  planner_->reset();
  recovery_.reset();
  recoveryStep_ = Recovery::Step::None;
  blocked_ = stepDone_ = stopping_ = atGoal_ = turning_ = backingOff_ = false;
}

Motion MotionPlanner::step(const Input& input, const CostGrid& costs) {
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
      motion.command = brake(input.commandBase, limits_, controlPeriod_s_);
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

Motion MotionPlanner::arrive(const Input& input, const CostGrid& costs) {
  Motion motion;
  const double error = mrpt::math::wrapToPi(input.goal.phi - input.mapFromRobot.phi);
  if (atGoal_ && parameters_.alignAtGoal && std::abs(error) > parameters_.headingTolerance_rad) {
    motion = rotate(MotionMode::RotateToGoal, error, input, costs);
    if (!motion.blocked) return motion;  // without room to turn, being there has to do
    motion.blocked = false;
  }
  const bool arrived = atGoal_ && isStanding(input.twist);
  motion.mode = arrived ? MotionMode::Arrived : MotionMode::StopAtGoal;
  motion.command = brake(input.commandBase, limits_, controlPeriod_s_);
  return motion;
}

Motion MotionPlanner::follow(const Input& input, const CostGrid& costs) {
  Motion motion;
  motion.mode = MotionMode::Follow;
  if (input.path.empty()) {
    motion.blocked = true;
    turning_ = false;
    motion.command = brake(input.commandBase, limits_, controlPeriod_s_);
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
    motion = rotate(MotionMode::RotateToPath, bearing, input, costs);
    motion.localGoal = localGoal;
    if (!motion.blocked) return motion;
    turning_ = false;
  }
  if (creeps) return creep(input, costs);
  motion = plan(input, costs);
  if (inTheWay) makeWay(input, costs, motion);
  return motion;
}

Motion MotionPlanner::plan(const Input& input, const CostGrid& costs) {
  const TPoint2D robot{input.mapFromRobot.x, input.mapFromRobot.y};
  const TPoint2D localGoal = pointAhead(input.path, robot, parameters_.lookahead_m);
  const bool stops = input.passWithin_m == 0.0;
  const bool atEnd = (localGoal - input.path.back()).norm() < 1e-9;
  const double tolerance_m = stops ? parameters_.goalTolerance_m : input.passWithin_m;
  dwa_ = &planner_->plan({input.mapFromRobot, input.commandBase, input.path, localGoal,
                          atEnd ? tolerance_m : 0.0, atEnd && stops, input.guard, input.movers},
                         costs);
  Motion motion;
  motion.mode = MotionMode::Follow;
  motion.planned = true;
  motion.localGoal = localGoal;
  motion.command = dwa_->command;
  motion.blocked = dwa_->status == DwaResult::Status::NoAdmissible;
  return motion;
}

/** Drives straight back out of the way of people who walk, where that leaves them more room than
 * what was planned. */
void MotionPlanner::makeWay(const Input& input, const CostGrid& costs, Motion& motion) const {
  if (!input.looksBehind || input.twist.vx > kBackingFrom_mps) return;
  TTwist2D wanted;
  double least = dwa_->best < 0
                     ? input.movers->cost({})
                     : dwa_->candidates[static_cast<std::size_t>(dwa_->best)].terms.movers;
  for (const double speed : {0.1, 0.2, 0.3}) {
    const TTwist2D back{-std::min(speed, limits_.maxSpeed_mps), 0.0, 0.0};
    const double cost = input.movers->cost(back);
    if (cost > least - kWorthBacking || !isFree(back.vx, 0.0, input, costs)) continue;
    if (input.guard && !input.guard->admitsTowards(back, input.commandBase)) continue;
    wanted = back;
    least = cost;
  }
  if (wanted.vx == 0.0) return;
  motion.mode = MotionMode::MakeWay;
  motion.blocked = false;
  motion.command = limited(wanted, input.commandBase, limits_, controlPeriod_s_);
}

/** The fastest on an arc that is admissible, up to where the planner goes on; at least creeping. */
double MotionPlanner::creepSpeed_mps(double turn_radps, const Input& input) const {
  const double creep = std::min(input.guard->parameters().creepSpeed_mps, limits_.maxSpeed_mps);
  constexpr double kStep_mps = 0.01;
  for (double v = std::min(Guard::kWorthwhile_mps, limits_.maxSpeed_mps); v > creep; v -= kStep_mps)
    if (input.guard->admitsTowards({v, 0.0, turn_radps}, input.commandBase)) return v;
  return creep;
}

/** Keeps to the path: over the way of a few seconds, creeping candidates all but tie, and standing
 * with them. */
Motion MotionPlanner::creep(const Input& input, const CostGrid& costs) {
  const TPoint2D robot{input.mapFromRobot.x, input.mapFromRobot.y};
  const double bearing =
      bearingTo(input.mapFromRobot, pointAhead(input.path, robot, kCreepAhead_m));
  const double turn =
      std::clamp(bearing, -limits_.maxYawRate_radps, limits_.maxYawRate_radps);  // in a second
  const double speed = creepSpeed_mps(turn, input);
  Motion motion;
  motion.mode = MotionMode::Follow;
  motion.localGoal = pointAhead(input.path, robot, parameters_.lookahead_m);
  // Somebody may have come nearer than the robot would: away from there it may go.
  constexpr double kSight_m = 1.0;
  const TPoint2D ahead =
      robot + TPoint2D(std::cos(input.mapFromRobot.phi), std::sin(input.mapFromRobot.phi)) * 0.1;
  motion.blocked = !isFree(speed, turn, input, costs) &&
                   clearance(costs, ahead, kSight_m) <= clearance(costs, robot, kSight_m);
  if (!motion.blocked) recovery_.reset();  // slow, but not stuck
  motion.command = motion.blocked
                       ? brake(input.commandBase, limits_, controlPeriod_s_)
                       : limited({speed, 0.0, turn}, input.commandBase, limits_, controlPeriod_s_);
  return motion;
}

Motion MotionPlanner::rotate(MotionMode mode, double error_rad, const Input& input,
                             const CostGrid& costs) {
  Motion motion;
  motion.mode = mode;
  motion.blocked = !roomToTurn(error_rad, input, costs);
  motion.command = motion.blocked
                       ? brake(input.commandBase, limits_, controlPeriod_s_)
                       : rotateInPlace(error_rad, input.commandBase, limits_, controlPeriod_s_);
  return motion;
}

bool MotionPlanner::roomToTurn(double angle_rad, const Input& input, const CostGrid& costs) const {
  return isFree(0.0, std::copysign(std::min(std::abs(angle_rad), 0.5), angle_rad), input, costs);
}

bool MotionPlanner::isFree(double forward_m, double left_rad, const Input& input,
                           const CostGrid& costs) const {
  RolloutSetup setup;
  setup.start = input.mapFromRobot;
  setup.horizon_s = 1.0;
  setup.step_s = 0.05;
  setup.outlineReach_m = footprint_.reach_m();
  return !rollOut(forward_m, left_rad, setup, costs, footprint_).blocked();
}

Motion MotionPlanner::backOff(const Input& input, const CostGrid& costs) {
  if (!backingOff_) backOffFrom_ = input.mapFromRobot;
  backingOff_ = true;
  const auto& pose = input.mapFromRobot;
  const double moved = std::hypot(pose.x - backOffFrom_.x, pose.y - backOffFrom_.y);

  // Backwards if that leads away from obstacles, else forwards; never nearer to one than now,
  // unless there is room.
  constexpr double kSight_m = 1.0;
  const double now = clearance(costs, {pose.x, pose.y}, kSight_m);
  double direction = 0.0;
  for (const double side : {-1.0, 1.0}) {
    const double ahead = side * (limits_.maxSpeed_mps * controlPeriod_s_ + 0.1);
    const TPoint2D there{pose.x + ahead * std::cos(pose.phi), pose.y + ahead * std::sin(pose.phi)};
    const bool canBack = side < 0.0 && isFree(ahead, 0.0, input, costs);
    if (direction == 0.0 && (canBack || clearance(costs, there, kSight_m) > now)) direction = side;
  }
  Motion motion;
  motion.mode = MotionMode::BackOff;
  motion.command = limited({direction * recoveryParameters_.backOffSpeed_mps, 0.0, 0.0},
                           input.commandBase, limits_, controlPeriod_s_);
  stepDone_ = direction == 0.0 || moved >= recoveryParameters_.backOffDistance_m;
  if (stepDone_) {
    backingOff_ = false;
    motion.command = brake(input.commandBase, limits_, controlPeriod_s_);
  }
  return motion;
}

}  // namespace bslnav
