#include <bslnav/planning/Guard.h>
#include <bslnav/planning/GuardCosts.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "DwaGenerators.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;
using test::any;

constexpr double kRadius_m = 0.25, kPeriod_s = 0.1;

GuardParameters parameters() {
  GuardParameters p;
  p.enabled = true;
  return p;
}

FrontierPoint at(double x, double y) {
  return {static_cast<float>(x), static_cast<float>(y), FrontierPoint::Kind::Hidden};
}

Frontier anyFrontier(int most) {
  Frontier frontier;
  for (int i = *rc::gen::inRange(0, most + 1); i > 0; --i) {
    frontier.push_back(at(any(-3.0, 3.0), any(-3.0, 3.0)));
    frontier.back().kind = static_cast<FrontierPoint::Kind>(*rc::gen::inRange(0, 3));
  }
  return frontier;
}

TTwist2D anyCommand() { return {any(-0.2, 0.55), any(-0.3, 0.3), any(-1.0, 1.0)}; }

/** Along an endless frontier at distance D the bound is a·((D − radius − margin)/v_h − τ): with
 * D = 1.25 m, 0.5·((1.25 − 0.25 − 0.08)/1.111 − 0.2) = 0.314 m/s. */
TEST(Guard, BoundAlongAFrontierIsTheFormula) {
  Frontier line;
  for (double x = -4.0; x <= 6.0; x += 0.01) line.push_back(at(x, -1.25));
  Guard guard(parameters(), {}, kRadius_m, kPeriod_s);
  guard.begin({}, line, 0.0, false);
  EXPECT_NEAR(guard.bound_mps({0.3, 0.0, 0.0}), 0.31, 0.011);
  EXPECT_TRUE(guard.admits({0.30, 0.0, 0.0}));
  EXPECT_FALSE(guard.admits({0.33, 0.0, 0.0}));
}

/** What was seen 0.2 s ago may be 0.2 s nearer: as if τ were 0.4 s. */
TEST(Guard, AnOldFrontierIsNearer) {
  Frontier line;
  for (double x = -4.0; x <= 6.0; x += 0.01) line.push_back(at(x, -1.25));
  Guard guard(parameters(), {}, kRadius_m, kPeriod_s);
  guard.begin({}, line, 0.2, false);
  EXPECT_NEAR(guard.bound_mps({0.3, 0.0, 0.0}), 0.21, 0.011);
}

/** What computing takes counts as τ does: a·0.1 s less. */
TEST(Guard, ASlowComputerBrakesLater) {
  Frontier line;
  for (double x = -4.0; x <= 6.0; x += 0.01) line.push_back(at(x, -1.25));
  Guard guard(parameters(), {}, kRadius_m, kPeriod_s);
  guard.setComputing(0.1);
  guard.begin({}, line, 0.0, false);
  EXPECT_NEAR(guard.bound_mps({0.3, 0.0, 0.0}), 0.26, 0.011);
}

TEST(Guard, WithoutFrontierEverythingMayBeDriven) {
  Guard guard(parameters(), {}, kRadius_m, kPeriod_s);
  guard.begin({1.0, 2.0, 0.5}, {}, 0.0, false);
  EXPECT_TRUE(guard.admits({0.55, 0.0, 1.0}));
  EXPECT_DOUBLE_EQ(guard.bound_mps({0.1, 0.0, 0.0}), RobotLimits().maxSpeed_mps);
  EXPECT_EQ(guard.judge({0.55, 0.0, 1.0}).binding, -1);
}

TEST(Guard, AStandingRobotMayTurnWhoeverIsNear) {
  Guard guard(parameters(), {}, kRadius_m, kPeriod_s);
  guard.begin({}, {at(0.3, 0.0)}, 0.0, false);
  EXPECT_TRUE(guard.admits({0.0, 0.0, 1.0}));
  EXPECT_FALSE(guard.admits({0.03, 0.0, 0.0}));
}

TEST(Guard, CreepsOnlyWhenAllowed) {
  Guard guard(parameters(), {}, kRadius_m, kPeriod_s);
  guard.begin({}, {at(0.4, 0.0)}, 0.0, true);
  EXPECT_TRUE(guard.admits({0.04, 0.0, 0.0}));
  EXPECT_FALSE(guard.admits({0.06, 0.0, 0.0}));
}

/** Creeping is for places where nobody is seen, and past those who stand. */
TEST(Guard, WhoIsSeenWalkingIsNeverCreptAt) {
  Guard guard(parameters(), {}, kRadius_m, kPeriod_s);
  FrontierPoint somebody = at(0.4, 0.0);
  somebody.kind = FrontierPoint::Kind::Seen;
  guard.begin({}, {somebody}, 0.0, true);
  EXPECT_FALSE(guard.admits({0.04, 0.0, 0.0}));
  EXPECT_FALSE(guard.isBesideStanding());
  somebody.kind = FrontierPoint::Kind::Standing;
  guard.begin({}, {somebody}, 0.0, false);
  EXPECT_TRUE(guard.admits({0.04, 0.0, 0.0}));
  EXPECT_FALSE(guard.admits({0.06, 0.0, 0.0}));
  EXPECT_TRUE(guard.isBesideStanding());
  somebody.x_m = 1.5f;  // what is near now is hidden
  guard.begin({}, {somebody, at(0.4, 0.0)}, 0.0, false);
  EXPECT_FALSE(guard.isBesideStanding());
}

/** The binding point keeps its place in the frontier that was given. */
TEST(Guard, NamesWhatBinds) {
  Guard guard(parameters(), {}, kRadius_m, kPeriod_s);
  guard.begin({}, {at(-9.0, 0.0), at(2.0, 2.0), at(1.2, 0.0)}, 0.0, false);
  EXPECT_EQ(guard.judge({0.5, 0.0, 0.0}).binding, 2);
}

/** The fast condition is the plain one; both sample time, so they may differ where next to nothing
 * is left. */
RC_GTEST_PROP(GuardLaw, FastIsPlain, ()) {
  const Frontier frontier = anyFrontier(12);
  const TPose2D pose{any(-5.0, 5.0), any(-5.0, 5.0), any(-M_PI, M_PI)};
  const TTwist2D command = anyCommand();
  const double age_s = any(0.0, 0.3);
  Guard guard(parameters(), {}, kRadius_m, kPeriod_s);
  guard.begin(pose, frontier, age_s, false);
  const GuardVerdict plain =
      guardVerdict(command, pose, frontier, age_s, guard.robot(), parameters());
  if (std::abs(plain.slack_m) > 0.01) RC_ASSERT(guard.admits(command) == plain.admissible);
  if (plain.slack_m < 0.0) RC_ASSERT(std::abs(guard.judge(command).slack_m - plain.slack_m) < 0.04);
}

RC_GTEST_PROP(GuardLaw, MoreFrontierNeverAdmitsMore, ()) {
  Frontier frontier = anyFrontier(6);
  const TTwist2D command = anyCommand();
  Guard guard(parameters(), {}, kRadius_m, kPeriod_s);
  guard.begin({}, frontier, 0.0, false);
  const bool before = guard.admits(command);
  frontier.push_back(at(any(-2.0, 2.0), any(-2.0, 2.0)));
  guard.begin({}, frontier, 0.0, false);
  if (guard.admits(command)) RC_ASSERT(before);
}

/** The promise itself: while the robot drives an admitted command and brakes, nobody who walks from
 * a frontier point straight at where the robot will be gets there before it stands. */
RC_GTEST_PROP(GuardLaw, NobodyReachesAMovingRobot, ()) {
  const FrontierPoint from = at(any(-3.0, 3.0), any(-3.0, 3.0));
  const TTwist2D command = anyCommand();
  const double speed = std::hypot(command.vx, command.vy);
  RC_PRE(speed > 0.02);
  const RobotLimits limits;
  Guard guard(parameters(), limits, kRadius_m, kPeriod_s);
  guard.begin({}, {from}, 0.0, false);
  RC_PRE(guard.admits(command));
  TPose2D robot;
  TTwist2D twist = command;
  constexpr double kStep_s = 0.002;
  for (double t = 0.0; std::hypot(twist.vx, twist.vy) > 1e-3; t += kStep_s) {
    const double walked = parameters().personSpeed_mps * t;
    const double apart = std::hypot(from.x_m - robot.x, from.y_m - robot.y);
    RC_ASSERT(apart - walked > kRadius_m);
    if (t >= guard.robot().reaction_s) {
      const double part =
          std::max(0.0, 1.0 - limits.deceleration_mps2 * kStep_s / std::hypot(twist.vx, twist.vy));
      twist = {part * twist.vx, part * twist.vy, part * twist.omega};
    }
    robot = robot + TPose2D(twist.vx * kStep_s, twist.vy * kStep_s, twist.omega * kStep_s);
  }
}

RC_GTEST_PROP(GuardLaw, CappedIsAdmissibleOrBrakes, ()) {
  const RobotLimits limits;
  const TTwist2D now{any(0.05, 0.55), 0.0, any(-1.0, 1.0)};
  Guard guard(parameters(), limits, kRadius_m, kPeriod_s);
  guard.begin({}, anyFrontier(8), 0.0, false);
  const TTwist2D slowest = brakeAlongArc(now, limits, kPeriod_s);
  const TTwist2D sent = guard.capped(now, slowest);
  RC_ASSERT(guard.admits(sent) || (sent.vx == slowest.vx && sent.omega == slowest.omega));
}

/** From 0.4 m/s by 0.05: seven eighths, of the turn, too. */
TEST(BrakeAlongArc, KeepsTheCurvature) {
  const TTwist2D slower = brakeAlongArc({0.4, 0.0, 0.8}, {}, kPeriod_s);
  EXPECT_NEAR(slower.vx, 0.35, 1e-9);
  EXPECT_NEAR(slower.omega, 0.7, 1e-9);
}

/** Beside a frontier cell the way is dear, at full_m = 0.25 + 0.08 + 1.111·(0.2 + 1.111) = 1.79 m
 * free again, and blocked cells stay blocked. */
TEST(GuardCosts, FallWithTheDistance) {
  CostGrid costs(100, 100, 0.05, 0.0, 0.0);
  costs.at(costs.cellX(2.5), costs.cellY(3.0)) = kLethalCost;
  const Guard guard(parameters(), {}, kRadius_m, kPeriod_s);
  addGuardCosts({at(2.525, 2.525)}, parameters(), guard.robot(), RobotLimits().maxSpeed_mps, 3.0,
                costs);
  EXPECT_EQ(costs.costAt(2.6, 2.5), kHighestGradedCost);
  EXPECT_GT(costs.costAt(3.5, 2.5), costs.costAt(4.0, 2.5));
  EXPECT_EQ(costs.costAt(4.4, 2.5), kFreeCost);
  EXPECT_EQ(costs.costAt(2.5, 3.0), kLethalCost);
}

}  // namespace
}  // namespace bslnav
