#include "NavigationCycleRig.h"

namespace bslnav {
namespace {

using test::CycleRig;
using test::kPeriod_s;
using test::makeMap;
using test::makeScan;

NavigationParameters holonomic(int number) {
  NavigationParameters parameters = test::method(number);
  parameters.limits.maxLateralSpeed_mps = 0.4;
  parameters.dwa.speedSamples = 10;
  parameters.dwa.yawRateSamples = 15;
  parameters.dwa.lateralSamples = 7;
  return parameters;
}

TEST(HolonomicMotion, ArrivesAtTheGoalAndTakesUpItsHeading) {
  CycleRig rig(holonomic(1), makeMap(-2.0, -2.0, 5.0, 3.0));
  rig.cycle.setGoals({{3.0, 1.0, M_PI / 2.0}});
  double mostAside_mps = 0.0;
  for (int i = 0; i < 300 && rig.step().motion.mode != MotionMode::Arrived; ++i)
    mostAside_mps = std::max(mostAside_mps, std::abs(rig.twist.vy));
  EXPECT_LT(std::hypot(rig.pose.x - 3.0, rig.pose.y - 1.0), 0.1);
  EXPECT_NEAR(rig.pose.phi, M_PI / 2.0, 0.1);
  EXPECT_TRUE(isStanding(rig.twist));
  EXPECT_GT(mostAside_mps, 0.02);
}

TEST(HolonomicMotion, TurnsOnTheSpotToAPathBehind) {
  CycleRig rig(holonomic(1), makeMap(-5.0, -2.0, 2.0, 2.0));
  rig.cycle.setGoals({{-3.0, 0.0, M_PI}});
  EXPECT_EQ(rig.step().motion.mode, MotionMode::RotateToPath);
  ASSERT_TRUE(rig.driveUntil(MotionMode::Arrived, 30.0));
  EXPECT_LT(std::hypot(rig.pose.x + 3.0, rig.pose.y), 0.1);
}

TEST(HolonomicMotion, StopsSidewaysMotionWithoutGoals) {
  CycleRig rig(holonomic(1));
  rig.twist = {0.3, -0.4, 0.5};  // 0.5 m/s and 0.5 m/s²: a second
  for (int i = 0; i < 10; ++i) {
    rig.step();
    EXPECT_NEAR(rig.twist.vy / 0.4, -rig.twist.vx / 0.3, 1e-9);
  }
  EXPECT_NEAR(std::hypot(rig.twist.vx, rig.twist.vy), 0.0, 1e-9);
}

TEST(HolonomicMotion, BacksOffFromAWallAhead) {
  auto map = makeMap(-3.0, -3.0, 3.0, 3.0);
  test::occupy(*map, 0.3, -2.9, 0.4, 2.9);  // nearer than the horizon of any speed but zero
  CycleRig rig(holonomic(1), map);
  rig.cycle.setGoals({{2.0, 0.0, 0.0}});
  ASSERT_TRUE(rig.driveUntil(MotionMode::BackOff, 30.0));
  const double before = rig.pose.x;
  for (int i = 0; i < 100 && rig.step().motion.mode == MotionMode::BackOff; ++i) {
  }
  EXPECT_LT(rig.pose.x, before - 0.2);
}

TEST(HolonomicMotion, TurningInPlaceBrakesSidewaysMotionWithinTheLimits) {
  const RobotLimits limits = holonomic(1).limits;
  const auto command = rotateInPlace(1.0, {0.0, 0.3, 0.0}, limits, kPeriod_s);
  EXPECT_NEAR(command.vy, 0.25, 1e-12);  // 0.5 m/s² for 0.1 s
  EXPECT_NEAR(command.omega, 0.2, 1e-12);
}

/** Radius of the danger zones of a box at its left edge, of a robot with this velocity. */
double zoneRadius(const NavigationParameters& parameters, const mrpt::math::TTwist2D& twist) {
  CycleRig rig(parameters);
  rig.twist = twist;
  SensorFrame frame = rig.frame();
  frame.scans = {makeScan(0.0, [](int deg) { return deg >= 0 && deg <= 45 ? 2.0 : 5.0; })};
  return rig.cycle.step(frame).dangerZones.at(0).radius_m;
}

TEST(HolonomicMotion, DangerZonesGrowWithTheSpeedOfTheVector) {
  // v²/2a + L + X = 0.25 + 0.8 + 0.2 with 0.5 m/s; 0.09 + 1.0 with the 0.3 m/s forwards alone
  EXPECT_NEAR(zoneRadius(holonomic(2), {0.3, 0.4, 0.0}), 1.25, 1e-9);
  EXPECT_NEAR(zoneRadius(test::method(2), {0.3, 0.4, 0.0}), 1.09, 1e-9);
}

}  // namespace
}  // namespace bslnav
