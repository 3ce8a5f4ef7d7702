#include <bslnav/navigation/Clearance.h>
#include <bslnav/navigation/InPlaceRotation.h>
#include <bslnav/navigation/Maneuvers.h>
#include <bslnav/planning/PathDistance.h>
#include <bslnav/planning/Rollout.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TTwist2D;

constexpr double kBackingFrom_mps = 0.1;  // faster, it first brakes
constexpr double kWorthBacking = 0.02;    // less of c_mov is not
constexpr double kCreepAhead_m = 0.3;     // who creeps heads for this point of the path
constexpr double kSight_m = 1.0;          // farther obstacles do not matter here

}  // namespace

bool Maneuvers::canStopAfter(const TTwist2D& command, const MotionInput& input,
                             const CostGrid& costs) const {
  RolloutSetup setup;
  setup.start = input.mapFromRobot;
  setup.outlineReach_m = footprint_.reach_m();
  setup.allowUnknown = true;
  if (rollOut(TTwist2D(), setup, costs, footprint_).blocked()) return true;
  // Braking turns less and less: stopping sooner is another way, not a part of the same.
  for (const double keeps_s : {controlPeriod_s_, controlPeriod_s_ + limits_.response_s}) {
    setup.horizon_s = keeps_s;
    if (!isStoppingFree(command, setup, costs)) return false;
  }
  return true;
}

/** Whether nothing is touched by what is driven for the horizon and then braked from. */
bool Maneuvers::isStoppingFree(TTwist2D twist, RolloutSetup setup, const CostGrid& costs) const {
  while (twist != TTwist2D()) {
    const RolloutOutcome way = rollOut(twist, setup, costs, footprint_);
    if (way.blocked()) return false;
    setup.start = {way.endPoint.x, way.endPoint.y, setup.start.phi + twist.omega * setup.horizon_s};
    setup.horizon_s = controlPeriod_s_;
    twist = brake(twist, limits_, controlPeriod_s_);
  }
  return true;
}

Motion Maneuvers::rotate(MotionMode mode, double error_rad, const MotionInput& input,
                         const CostGrid& costs) const {
  Motion motion;
  motion.mode = mode;
  motion.blocked = !roomToTurn(error_rad, input, costs);
  motion.command = motion.blocked
                       ? braking(input)
                       : rotateInPlace(error_rad, input.commandBase, limits_, controlPeriod_s_);
  return motion;
}

Motion Maneuvers::creep(const MotionInput& input, const CostGrid& costs) const {
  const TPoint2D robot{input.mapFromRobot.x, input.mapFromRobot.y};
  const double bearing =
      bearingTo(input.mapFromRobot, pointAhead(input.path, robot, kCreepAhead_m));
  const double turn =
      std::clamp(bearing, -limits_.maxYawRate_radps, limits_.maxYawRate_radps);  // in a second
  const double speed = creepSpeed_mps(turn, input);
  Motion motion;
  motion.mode = MotionMode::Follow;
  // Somebody may have come nearer than the robot would: away from there it may go.
  const TPoint2D ahead =
      robot + TPoint2D(std::cos(input.mapFromRobot.phi), std::sin(input.mapFromRobot.phi)) * 0.1;
  motion.blocked = !isFree(speed, turn, input, costs) &&
                   clearance(costs, ahead, kSight_m) <= clearance(costs, robot, kSight_m);
  motion.command = motion.blocked
                       ? braking(input)
                       : limited({speed, 0.0, turn}, input.commandBase, limits_, controlPeriod_s_);
  return motion;
}

/** The fastest on an arc that is admissible, up to where the planner goes on; at least creeping. */
double Maneuvers::creepSpeed_mps(double turn_radps, const MotionInput& input) const {
  const double creep = std::min(input.guard->parameters().creepSpeed_mps, limits_.maxSpeed_mps);
  constexpr double kStep_mps = 0.01;
  for (double v = std::min(Guard::kWorthwhile_mps, limits_.maxSpeed_mps); v > creep; v -= kStep_mps)
    if (input.guard->admitsTowards({v, 0.0, turn_radps}, input.commandBase)) return v;
  return creep;
}

std::optional<Motion> Maneuvers::makeWay(double least, const MotionInput& input,
                                         const CostGrid& costs) const {
  if (!input.looksBehind || input.twist.vx > kBackingFrom_mps) return std::nullopt;
  TTwist2D wanted;
  for (const double speed : {0.1, 0.2, 0.3}) {
    const TTwist2D back{-std::min(speed, limits_.maxSpeed_mps), 0.0, 0.0};
    const double cost = input.movers->cost(back);
    if (cost > least - kWorthBacking || !isFree(back.vx, 0.0, input, costs)) continue;
    if (input.guard && !input.guard->admitsTowards(back, input.commandBase)) continue;
    wanted = back;
    least = cost;
  }
  if (wanted.vx == 0.0) return std::nullopt;
  Motion motion;
  motion.mode = MotionMode::MakeWay;
  motion.command = limited(wanted, input.commandBase, limits_, controlPeriod_s_);
  return motion;
}

double Maneuvers::wayOff(const MotionInput& input, const CostGrid& costs) const {
  const auto& pose = input.mapFromRobot;
  const double now = clearance(costs, {pose.x, pose.y}, kSight_m);
  for (const double side : {-1.0, 1.0}) {
    const double ahead = side * (limits_.maxSpeed_mps * controlPeriod_s_ + 0.1);
    const TPoint2D there{pose.x + ahead * std::cos(pose.phi), pose.y + ahead * std::sin(pose.phi)};
    const bool canBack = side < 0.0 && isFree(ahead, 0.0, input, costs);
    if (canBack || clearance(costs, there, kSight_m) > now) return side;
  }
  return 0.0;
}

bool Maneuvers::roomToTurn(double angle_rad, const MotionInput& input,
                           const CostGrid& costs) const {
  return isFree(0.0, std::copysign(std::min(std::abs(angle_rad), 0.5), angle_rad), input, costs);
}

bool Maneuvers::isFree(double forward_m, double left_rad, const MotionInput& input,
                       const CostGrid& costs) const {
  RolloutSetup setup;
  setup.start = input.mapFromRobot;
  setup.horizon_s = 1.0;
  setup.step_s = 0.05;
  setup.outlineReach_m = footprint_.reach_m();
  return !rollOut(forward_m, left_rad, setup, costs, footprint_).blocked();
}

}  // namespace bslnav
