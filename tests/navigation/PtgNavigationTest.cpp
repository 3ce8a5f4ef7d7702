#include <bslnav/navigation/BlindSpotReactiveNavigator.h>
#include <gmock/gmock.h>

#include "PtgRig.h"

namespace bslnav {
namespace {

class BlindSpotReactiveNavigatorTest : public testing::Test {
 protected:
  void load() {
    navigator.setMinLoggingLevel(mrpt::system::LVL_ERROR);
    navigator.silence();
    ini.write("bslnav", "method", 2);
    navigator.loadConfigFile(ini);
    navigator.initialize();
  }

  test::PtgRobot robot;
  mrpt::config::CConfigFileMemory ini = test::reactiveIni();
  BlindSpotReactiveNavigator navigator{robot, false};
};

TEST_F(BlindSpotReactiveNavigatorTest, DrivesRoundAWallToTheTarget) {
  load();
  robot.addWall(1.5, -3.0, 1.5, 0.3);
  test::navigateTo(navigator, 3.0, 0.0);
  test::drive(navigator, robot, 60.0);
  const auto pose = robot.vehicle.getCurrentGTPose();
  EXPECT_LT(std::hypot(pose.x - 3.0, pose.y), 0.25) << navigator.problem();
  EXPECT_EQ(robot.events, "start end ");
}

TEST_F(BlindSpotReactiveNavigatorTest, FindsTheBlindSpotAtAWallsEnd) {
  load();
  robot.addWall(1.5, -3.0, 1.5, -0.5);
  robot.addWall(6.0, -4.0, 6.0, 4.0);
  test::navigateTo(navigator, 4.0, 0.5);
  test::drive(navigator, robot, 0.3);
  const CycleRecord record = navigator.lastRecord();
  ASSERT_FALSE(record.blindSpots.empty());
  double nearest_m = 1e9;
  for (const DangerZone& zone : record.dangerZones)
    nearest_m = std::min(nearest_m, std::hypot(zone.centre.x - 1.5, zone.centre.y + 0.5));
  EXPECT_LT(nearest_m, 0.6);  // H_w tan(theta) beside the wall's end
}

TEST_F(BlindSpotReactiveNavigatorTest, KeepsTheAccelerationLimits) {
  load();
  test::navigateTo(navigator, 2.0, 0.0);
  test::drive(navigator, robot, 20.0);
  ASSERT_GT(robot.commands.size(), 20U);
  for (std::size_t i = 1; i < robot.commands.size(); ++i)
    EXPECT_LE(std::abs(robot.commands[i] - robot.commands[i - 1]), 0.5 * 0.1 + 0.051) << i;
}

TEST_F(BlindSpotReactiveNavigatorTest, AFailingStepEndsTheNavigationAndSaysWhy) {
  load();
  test::navigateTo(navigator, 5.0, 0.0);
  test::drive(navigator, robot, 1.0);
  robot.throwsNow = true;
  test::drive(navigator, robot, 1.0);
  EXPECT_EQ(navigator.getCurrentState(), BlindSpotReactiveNavigator::NAV_ERROR);
  EXPECT_THAT(navigator.problem(), testing::HasSubstr("the laser is on fire"));
  EXPECT_THAT(robot.events, testing::HasSubstr("error"));
}

TEST_F(BlindSpotReactiveNavigatorTest, BrakesWithinTheLimitsWhereThereIsNoWay) {
  load();
  test::navigateTo(navigator, 5.0, 0.0);
  test::drive(navigator, robot, 3.0);
  ASSERT_GT(robot.commands.back(), 0.4);
  const double x = robot.vehicle.getCurrentGTPose().x;
  robot.addWall(x + 0.9, -3.0, x + 0.9, 3.0);  // all of a sudden, all around
  robot.addWall(x - 2.0, 3.0, x + 0.9, 3.0);
  robot.addWall(x - 2.0, -3.0, x + 0.9, -3.0);
  robot.addWall(x - 2.0, -3.0, x - 2.0, 3.0);
  test::drive(navigator, robot, 0.8);
  EXPECT_LT(robot.commands.back(), 0.2);
  for (std::size_t i = 1; i < robot.commands.size(); ++i)
    EXPECT_LE(robot.commands[i - 1] - robot.commands[i], 0.5 * 0.1 + 0.051) << i;
}

TEST_F(BlindSpotReactiveNavigatorTest, ArrivesStanding) {
  load();
  test::navigateTo(navigator, 2.0, 0.0);
  test::drive(navigator, robot, 60.0);
  ASSERT_EQ(robot.events, "start end ");
  ASSERT_FALSE(robot.speedsAtStop.empty());
  for (const double speed : robot.speedsAtStop) EXPECT_LT(std::abs(speed), 0.05);
}

TEST_F(BlindSpotReactiveNavigatorTest, WithoutConfigurationItFailsAndDoesNotCrash) {
  navigator.setMinLoggingLevel(mrpt::system::LVL_ERROR);
  test::navigateTo(navigator, 1.0, 0.0);
  for (int i = 0; i < 3; ++i) navigator.navigationStep();
  EXPECT_NE(navigator.getCurrentState(), BlindSpotReactiveNavigator::NAVIGATING);
}

TEST_F(BlindSpotReactiveNavigatorTest, RefusesItsSectionsMistakes) {
  ini.write("bslnav", "methd", 2);
  EXPECT_THROW(navigator.loadConfigFile(ini), std::exception);
}

TEST(ScanOfPoints, HasTheNearestPointOfEachDirection) {
  mrpt::maps::CSimplePointsMap points;
  points.insertPoint(2.0f, 0.0f, 0.0f);
  points.insertPoint(3.0f, 0.0f, 0.0f);
  points.insertPoint(0.0f, 1.0f, 0.0f);
  const auto scan = scanOf(points, 360, 10.0);
  const double step = scan->aperture / 359.0,
               first = -0.5 * scan->aperture + scan->sensorPose.yaw();
  int valid = 0;
  for (std::size_t i = 0; i < scan->getScanSize(); ++i) {
    if (!scan->getScanRangeValidity(i)) continue;
    ++valid;
    const double bearing = first + step * static_cast<double>(i);
    const bool ahead = std::abs(bearing) < 1e-6;
    EXPECT_TRUE(ahead || std::abs(bearing - M_PI / 2) < 1e-6) << bearing;
    EXPECT_FLOAT_EQ(scan->getScanRange(i), ahead ? 2.0f : 1.0f);
  }
  EXPECT_EQ(valid, 2);
}

}  // namespace
}  // namespace bslnav
