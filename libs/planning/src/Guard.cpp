#include <bslnav/planning/Guard.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;

constexpr double kStanding_mps = 1e-3;
constexpr double kFinest_s = 0.005;  // of the steps along an arc

/** The way of a command: an arc that is driven at a speed and then braked on. */
struct StoppingWay {
  TPose2D start;  // heading: that of the motion
  double speed_mps, curvature_per_m, reaction_s, deceleration_mps2;

  StoppingWay(const TTwist2D& command, const TPose2D& pose, const StoppingAbility& robot)
      : start(pose.x, pose.y, pose.phi + std::atan2(command.vy, command.vx)),
        speed_mps(std::abs(speedOf(command))),
        curvature_per_m(command.omega / speed_mps),
        reaction_s(robot.reaction_s),
        deceleration_mps2(robot.deceleration_mps2) {}

  double duration_s() const { return reaction_s + speed_mps / deceleration_mps2; }
  double length_m() const {
    return speed_mps * reaction_s + 0.5 * speed_mps * speed_mps / deceleration_mps2;
  }
  double driven_m(double time_s) const {
    const double braking_s = std::clamp(time_s - reaction_s, 0.0, speed_mps / deceleration_mps2);
    return speed_mps * std::min(time_s, reaction_s) +
           braking_s * (speed_mps - 0.5 * deceleration_mps2 * braking_s);
  }
  double speedAt_mps(double time_s) const {
    return std::max(0.0, speed_mps - deceleration_mps2 * std::max(0.0, time_s - reaction_s));
  }
  TPoint2D at(double time_s) const {
    const double s = driven_m(time_s), half = 0.5 * curvature_per_m * s;
    const double chord = std::abs(half) < 1e-6 ? s : s * std::sin(half) / half;
    return {start.x + chord * std::cos(start.phi + half),
            start.y + chord * std::sin(start.phi + half)};
  }
};

bool isStanding(const TTwist2D& command) { return std::abs(speedOf(command)) < kStanding_mps; }

}  // namespace

void GuardParameters::describe(ConfigSection& section) {
  section.flag("enabled", enabled,
               "whether only velocities are driven from which the robot stands before anybody who "
               "may step out (Method 5)");
  section.number("person_speed_mps", personSpeed_mps, {0.0, 10.0}, "m/s",
                 "v_h: nobody walks faster");
  section.number("latency_s", latency_s, {0.0, 5.0}, "s",
                 "from a command to its effect, besides the control period");
  section.number("margin_m", margin_m, {0.0, 2.0}, "m",
                 "for noise of ranges and pose, and half a cell of the grid of hidden people");
  section.number("noise_m", noise_m, {0.0, 2.0}, "m",
                 "so much of the margin may be used up, by ranges that are not exact, before the "
                 "record says that the guarantee lapsed");
  section.number("creep_after_s", creepAfter_s, kNonNegative, "s",
                 "standing so long with nothing admissible, the robot may creep; the record says "
                 "that the guarantee lapsed");
  section.number("creep_speed_mps", creepSpeed_mps, {0.0, 1.0}, "m/s",
                 "how fast; 0: it waits for ever");
}

StoppingAbility stoppingAbility(const RobotLimits& limits, const GuardParameters& guard,
                                double radius_m, double controlPeriod_s) {
  return {radius_m, limits.deceleration_mps2, controlPeriod_s + guard.latency_s};
}

GuardVerdict guardVerdict(const TTwist2D& command, const TPose2D& mapFromRobot,
                          const Frontier& frontier, double age_s, const StoppingAbility& robot,
                          const GuardParameters& parameters) {
  GuardVerdict verdict;
  verdict.slack_m = kGuardReach_m;
  if (isStanding(command)) return verdict;
  const StoppingWay way(command, mapFromRobot, robot);
  constexpr double kStep_s = 1e-3;
  const int steps = static_cast<int>(std::ceil(way.duration_s() / kStep_s));
  const bool creeps = way.speed_mps <= parameters.creepSpeed_mps + kStanding_mps;
  for (int k = 0; k <= steps; ++k) {
    const double t = std::min(k * kStep_s, way.duration_s());
    const TPoint2D centre = way.at(t);
    const double needed =
        robot.radius_m + parameters.personSpeed_mps * (t + age_s) + parameters.margin_m;
    for (std::size_t i = 0; i < frontier.size(); ++i) {
      if (creeps && frontier[i].kind == FrontierPoint::Kind::Standing) continue;
      const double slack =
          std::hypot(frontier[i].x_m - centre.x, frontier[i].y_m - centre.y) - needed;
      if (slack <= 0.0) verdict.impact_mps = std::max(verdict.impact_mps, way.speedAt_mps(t));
      if (slack >= verdict.slack_m) continue;
      verdict.slack_m = slack;
      verdict.binding = static_cast<int>(i);
    }
  }
  verdict.admissible = verdict.slack_m > 0.0;
  return verdict;
}

Guard::Guard(const GuardParameters& parameters, const RobotLimits& limits, double robotRadius_m,
             double controlPeriod_s)
    : parameters_(parameters),
      limits_(limits),
      period_s_(controlPeriod_s),
      robot_(stoppingAbility(limits, parameters, robotRadius_m, controlPeriod_s)) {}

void Guard::begin(const TPose2D& mapFromRobot, const Frontier& frontier, double age_s,
                  bool mayCreep) {
  pose_ = mapFromRobot;
  age_s_ = age_s;
  mayCreep_ = mayCreep;
  x_m_.clear();
  y_m_.clear();
  index_.clear();
  // The fastest command decides how far a point may be and still matter.
  const StoppingWay fastest({1.1 * limits_.maxSpeed_mps + 0.1, 0.0, 0.0}, pose_, robot_);
  const double reach = fastest.length_m() + robot_.radius_m + parameters_.margin_m +
                       parameters_.personSpeed_mps * (fastest.duration_s() + age_s);
  using Kind = FrontierPoint::Kind;
  for (const Kind kind : {Kind::Seen, Kind::Hidden, Kind::Standing}) {
    for (std::size_t i = 0; i < frontier.size(); ++i) {
      if (frontier[i].kind != kind) continue;
      const auto dx = static_cast<float>(frontier[i].x_m - pose_.x);
      const auto dy = static_cast<float>(frontier[i].y_m - pose_.y);
      if (dx * dx + dy * dy > reach * reach) continue;
      x_m_.push_back(dx);
      y_m_.push_back(dy);
      index_.push_back(static_cast<int>(i));
    }
    if (kind == Kind::Seen) seen_ = x_m_.size();
    if (kind == Kind::Hidden) walking_ = x_m_.size();
  }
  pose_.x = pose_.y = 0.0;  // all is relative to the robot now, but for the heading
  distanceNow_m_ = nearest(0.0f, 0.0f, x_m_.size());
}

bool Guard::isBesideStanding() const {
  const double needed = robot_.radius_m + parameters_.margin_m +
                        parameters_.personSpeed_mps * (age_s_ + robot_.reaction_s +
                                                       kWorthwhile_mps / robot_.deceleration_mps2);
  for (std::size_t i = walking_; i < x_m_.size(); ++i)
    if (std::hypot(x_m_[i], y_m_[i]) <= needed) return true;
  return false;
}

float Guard::nearest(float x_m, float y_m, std::size_t count, std::size_t* which) const {
  float least = static_cast<float>(kGuardReach_m * kGuardReach_m);
  if (!which) {
    for (std::size_t i = 0; i < count; ++i) {
      const float dx = x_m_[i] - x_m, dy = y_m_[i] - y_m;
      const float squared = dx * dx + dy * dy;
      least = squared < least ? squared : least;
    }
    return std::sqrt(least);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const float dx = x_m_[i] - x_m, dy = y_m_[i] - y_m;
    const float squared = dx * dx + dy * dy;
    if (squared >= least) continue;
    least = squared;
    *which = i;
  }
  return std::sqrt(least);
}

bool Guard::admits(const TTwist2D& command) const {
  if (x_m_.empty() || isStanding(command)) return true;
  const StoppingWay way(command, pose_, robot_);
  const std::size_t points = refusing(way.speed_mps);
  // What is left changes by no more than this a second: where much is left, much time is skipped.
  const double closing_mps = way.speed_mps + parameters_.personSpeed_mps;
  const double end_s = way.duration_s();
  const double needed =
      robot_.radius_m + parameters_.margin_m + parameters_.personSpeed_mps * age_s_;
  const float now_m = points == x_m_.size() ? distanceNow_m_ : nearest(0.0f, 0.0f, points);
  double left = now_m - needed;
  for (double t = 0.0;;) {
    if (left <= 0.0) return false;
    if (t >= end_s) return true;
    t = std::min(end_s, t + std::max(kFinest_s, left / closing_mps));
    const TPoint2D centre = way.at(t);
    left = nearest(static_cast<float>(centre.x), static_cast<float>(centre.y), points) - needed -
           parameters_.personSpeed_mps * t;
  }
}

GuardVerdict Guard::judge(const TTwist2D& command) const {
  GuardVerdict verdict;
  verdict.admissible = admits(command);
  verdict.slack_m = kGuardReach_m;
  if (x_m_.empty() || isStanding(command)) return verdict;
  const StoppingWay way(command, pose_, robot_);
  const double needed = robot_.radius_m + parameters_.margin_m;
  const int steps = static_cast<int>(std::ceil(way.duration_s() / 0.02));
  for (int k = 0; k <= steps; ++k) {
    const double t = std::min(k * 0.02, way.duration_s());
    const TPoint2D centre = way.at(t);
    std::size_t which = 0;
    const double slack = nearest(static_cast<float>(centre.x), static_cast<float>(centre.y),
                                 promised(way.speed_mps), &which) -
                         needed - parameters_.personSpeed_mps * (t + age_s_);
    if (slack <= 0.0) verdict.impact_mps = std::max(verdict.impact_mps, way.speedAt_mps(t));
    if (slack >= verdict.slack_m) continue;
    verdict.slack_m = slack;
    verdict.binding = index_[which];
  }
  return verdict;
}

double Guard::bound_mps(const TTwist2D& arc) const {
  const double speed = std::abs(speedOf(arc));
  const TTwist2D unit = speed < kStanding_mps
                            ? TTwist2D{1.0, 0.0, 0.0}
                            : TTwist2D{arc.vx / speed, arc.vy / speed, arc.omega / speed};
  constexpr double kStep_mps = 0.01;
  double bound = 0.0;
  for (double v = kStep_mps; v < limits_.maxSpeed_mps + kStep_mps; v += kStep_mps) {
    const double tried = std::min(v, limits_.maxSpeed_mps);
    if (!admits({tried * unit.vx, tried * unit.vy, tried * unit.omega})) break;
    bound = tried;
  }
  return bound;
}

TTwist2D Guard::capped(const TTwist2D& command, const TTwist2D& slowest) const {
  if (admits(command)) return command;
  const double from = std::abs(speedOf(command));
  const double to = std::abs(speedOf(slowest));
  constexpr int kSteps = 10;
  for (int k = 1; k < kSteps && to < from; ++k) {
    const double part = (from + (to - from) * k / kSteps) / from;
    const TTwist2D slower{part * command.vx, part * command.vy, part * command.omega};
    if (admits(slower)) return slower;
  }
  return slowest;
}

TTwist2D brakeAlongArc(const TTwist2D& current, const RobotLimits& limits, double period_s) {
  TTwist2D slower = brake(current, limits, period_s);
  const double before = std::abs(speedOf(current));
  if (before < kStanding_mps) return slower;
  const double part = std::abs(speedOf(slower)) / before;
  const double turn = limits.yawAcceleration_radps2 * period_s;
  slower.omega = std::clamp(part * current.omega, current.omega - turn, current.omega + turn);
  return slower;
}

}  // namespace bslnav
