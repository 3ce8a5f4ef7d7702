#include <bslnav/navigation/CycleRecord.h>
#include <bslnav/navigation/MotionGuard.h>
#include <gtest/gtest.h>

#include "NavigationCycleRig.h"

namespace bslnav {
namespace {

using mrpt::math::TTwist2D;
using Lapse = GuardRecord::Lapse;

constexpr double kRadius_m = 0.25;

MotionGuard motionGuard(const GuardParameters& parameters = {}) {
  return MotionGuard(parameters, {}, kRadius_m, test::kPeriod_s);
}

Frontier ahead(double x_m) {
  return {{static_cast<float>(x_m), 0.0f, FrontierPoint::Kind::Hidden}};
}

/** One cycle at the origin in which a planner that knows no guard wants a command. */
CycleRecord cycle(MotionGuard& guard, double time_s, const Frontier& frontier, const TTwist2D& base,
                  const TTwist2D& wanted) {
  CycleRecord record;
  record.time_s = time_s;
  guard.begin(record, frontier, time_s);
  record.motion.command = wanted;
  record.motion.planned = true;
  guard.finish(base, frontier, record);
  return record;
}

/** From 0.5 m/s with somebody 1 m ahead nothing is admissible: as hard as 0.5 m/s² for 0.1 s
 * allow. The record says that this does not suffice. */
TEST(MotionGuard, BrakesWhateverThePlannerWants) {
  MotionGuard guard = motionGuard();
  const CycleRecord record = cycle(guard, 0.0, ahead(1.0), {0.5, 0.0, 0.0}, {0.5, 0.0, 0.0});
  EXPECT_NEAR(record.motion.command.vx, 0.45, 1e-9);
  EXPECT_TRUE(record.guard.capped);
  EXPECT_EQ(record.guard.lapse, Lapse::Surprised);
  EXPECT_GT(record.guard.impact_mps, 0.0);
  ASSERT_TRUE(record.guard.binding.has_value());
  EXPECT_FLOAT_EQ(record.guard.binding->x_m, 1.0f);
}

TEST(MotionGuard, LeavesAnAdmissibleCommandAlone) {
  MotionGuard guard = motionGuard();
  const CycleRecord record = cycle(guard, 0.0, ahead(3.5), {0.5, 0.0, 0.0}, {0.55, 0.0, 0.1});
  EXPECT_EQ(record.motion.command.vx, 0.55);
  EXPECT_EQ(record.motion.command.omega, 0.1);
  EXPECT_FALSE(record.guard.capped);
  EXPECT_EQ(record.guard.lapse, Lapse::None);
  EXPECT_GT(record.guard.slack_m, 0.0);
  EXPECT_EQ(record.guard.hidden, 1);
}

/** Standing before a hidden place 0.5 m away, it waits for 10 s, then drives at 0.04 m/s at most.
 */
TEST(MotionGuard, CreepsAfterAWhile) {
  MotionGuard guard = motionGuard();
  for (double t = 0.0; t < 9.95; t += 0.1)
    ASSERT_EQ(cycle(guard, t, ahead(0.5), {}, {0.04, 0.0, 0.0}).motion.command.vx, 0.0) << t;
  cycle(guard, 10.0, ahead(0.5), {}, {0.04, 0.0, 0.0});
  const CycleRecord record = cycle(guard, 10.1, ahead(0.5), {}, {0.04, 0.0, 0.0});
  EXPECT_EQ(record.motion.command.vx, 0.04);
  EXPECT_EQ(record.guard.lapse, Lapse::Creeping);
  EXPECT_NEAR(cycle(guard, 10.2, ahead(0.5), {}, {0.05, 0.0, 0.0}).motion.command.vx, 0.04, 1e-9);
}

Frontier somebodyAhead(double x_m, FrontierPoint::Kind kind) {
  return {{static_cast<float>(x_m), 0.0f, kind}};
}

/** A hidden place stays as it is however long one waits; a person walks on. */
TEST(MotionGuard, NeverCreepsBeforeSomebodyWhoWalks) {
  MotionGuard guard = motionGuard();
  const Frontier somebody = somebodyAhead(0.5, FrontierPoint::Kind::Seen);
  for (double t = 0.0; t < 20.0; t += 0.1)
    ASSERT_EQ(cycle(guard, t, somebody, {}, {0.04, 0.0, 0.0}).motion.command.vx, 0.0) << t;
}

/** Who has stood for a while is an obstacle for a robot that creeps, and no lapse. */
TEST(MotionGuard, CreepsPastSomebodyWhoStandsAtOnce) {
  MotionGuard guard = motionGuard();
  const Frontier somebody = somebodyAhead(0.5, FrontierPoint::Kind::Standing);
  const CycleRecord record = cycle(guard, 0.0, somebody, {}, {0.04, 0.0, 0.0});
  EXPECT_EQ(record.motion.command.vx, 0.04);
  EXPECT_EQ(record.guard.lapse, Lapse::None);
  EXPECT_LT(cycle(guard, 0.1, somebody, {0.04, 0.0, 0.0}, {0.06, 0.0, 0.0}).motion.command.vx,
            0.041);
}

/** Beside somebody who stands, the shadow of that person may bind even a robot that creeps: then it
 * waits as everywhere, whoever made the command. */
TEST(MotionGuard, WaitsAndCreepsWhenWhatIsHiddenBehindAPersonBinds) {
  MotionGuard guard = motionGuard();
  Frontier frontier = somebodyAhead(0.5, FrontierPoint::Kind::Standing);
  frontier.push_back(ahead(0.5).front());
  const auto creep = [&](double time_s) {
    CycleRecord record;
    record.time_s = time_s;
    guard.begin(record, frontier, time_s);
    record.motion.command = {0.04, 0.0, 0.0};
    guard.finish({}, frontier, record);
    return record;
  };
  for (double t = 0.0; t < 9.95; t += 0.1) {
    ASSERT_EQ(creep(t).motion.command.vx, 0.0) << t;
    EXPECT_TRUE(guard.isWaiting());
  }
  creep(10.0);
  EXPECT_EQ(creep(10.1).motion.command.vx, 0.04);
  EXPECT_EQ(creep(10.2).guard.lapse, Lapse::Creeping);
}

/** The robot can brake to 0.5 m/s, for which somebody 2.01 m ahead is just too near. What ranges
 * that are not exact may take of the margin is no lapse; more is one. It brakes either way. */
TEST(MotionGuard, NoiseWithinTheMarginIsNoLapse) {
  const double enough_m = 0.25 + 0.08 + 0.5 * 0.2 + 0.5 * 0.5 + (4.0 / 3.6) * 1.2;
  for (const double nearer_m : {0.02, 0.06}) {
    MotionGuard guard = motionGuard();
    const CycleRecord record =
        cycle(guard, 0.0, ahead(enough_m - nearer_m), {0.55, 0.0, 0.0}, {0.55, 0.0, 0.0});
    EXPECT_NEAR(record.motion.command.vx, 0.5, 1e-9);
    EXPECT_NEAR(record.guard.slack_m, -nearer_m, 0.01);
    EXPECT_EQ(record.guard.lapse, nearer_m < 0.04 ? Lapse::None : Lapse::Surprised);
  }
}

/** Turning on the spot towards where it may creep, the robot does not begin to wait anew. */
TEST(MotionGuard, TurningOnTheSpotIsNoReasonToWaitAgain) {
  MotionGuard guard = motionGuard();
  for (double t = 0.0; t < 10.05; t += 0.1) {
    EXPECT_EQ(guard.isWaiting(), t > 0.05);
    cycle(guard, t, ahead(0.5), {}, {0.04, 0.0, 0.0});
  }
  EXPECT_FALSE(guard.isWaiting());
  for (double t = 10.1; t < 11.0; t += 0.1) {
    CycleRecord record;
    record.time_s = t;
    guard.begin(record, ahead(0.5), t);
    record.motion.command = {0.0, 0.0, 0.3};
    guard.finish({}, ahead(0.5), record);
  }
  EXPECT_EQ(cycle(guard, 11.1, ahead(0.5), {}, {0.04, 0.0, 0.0}).motion.command.vx, 0.04);
}

TEST(MotionGuard, NeverCreepsWhenToldSo) {
  GuardParameters parameters;
  parameters.creepSpeed_mps = 0.0;
  MotionGuard guard = motionGuard(parameters);
  for (double t = 0.0; t < 10.0; t += 0.1)
    ASSERT_EQ(cycle(guard, t, ahead(0.5), {}, {0.04, 0.0, 0.0}).motion.command.vx, 0.0) << t;
}

/** Without a usable beam the cycle brakes; the certificate says that it promises nothing. */
TEST(MotionGuard, ABlindCycleIsALapse) {
  NavigationParameters parameters = test::method(1);
  parameters.guard.enabled = true;
  NavigationCycle cycle(parameters, test::makeMap(-2.0, -3.0, 8.0, 3.0));
  cycle.setGoals({{6.0, 0.0, 0.0}});
  SensorFrame frame;
  frame.startTime_s = test::kStart_s;
  frame.twist.vx = 0.5;
  frame.scans = {test::makeScan(0.0, [](int) { return std::nan(""); })};
  const CycleRecord& record = cycle.step(frame);
  ASSERT_EQ(record.health, CycleRecord::Health::NoBeams);
  EXPECT_NEAR(record.motion.command.vx, 0.45, 1e-9);
  EXPECT_TRUE(record.guard.active);
  EXPECT_EQ(record.guard.lapse, Lapse::Blind);
  EXPECT_NEAR(record.guard.impact_mps, 0.45, 1e-9);
}

}  // namespace
}  // namespace bslnav
