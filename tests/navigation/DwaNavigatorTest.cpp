#include <bslnav/navigation/DwaNavigator.h>
#include <gmock/gmock.h>

#include <atomic>
#include <thread>

#include "NavigationCycleRig.h"
#include "PtgRig.h"

namespace bslnav {
namespace {

class DwaNavigatorTest : public testing::Test {
 protected:
  DwaNavigatorTest() {
    navigator.setMinLoggingLevel(mrpt::system::LVL_ERROR);
    ini.write("bslnav", "method", 1);
    ini.write("motion", "goal_tolerance_m", 0.1);
    navigator.loadConfigFile(ini);
    navigator.initialize();
  }

  test::PtgRobot robot_;
  mrpt::config::CConfigFileMemory ini;
  DwaNavigator navigator{robot_};
};

TEST_F(DwaNavigatorTest, DrivesRoundAWallToTheTargetAndSaysSo) {
  robot_.addWall(1.5, -3.0, 1.5, 0.3);
  test::navigateTo(navigator, 3.0, 0.0);
  test::drive(navigator, robot_, 60.0);
  const auto pose = robot_.vehicle.getCurrentGTPose();
  EXPECT_LT(std::hypot(pose.x - 3.0, pose.y), 0.25)
      << nameOf(navigator.lastRecord().motion.mode) << " "
      << navigator.lastRecord().blindSpots.size();
  EXPECT_EQ(navigator.getCurrentState(), DwaNavigator::IDLE);
  EXPECT_EQ(robot_.events, "start end ");
  EXPECT_FALSE(navigator.lastRecord().dwa.candidates.empty());
}

TEST_F(DwaNavigatorTest, KeepsTheLimitsFromCommandToCommand) {
  test::navigateTo(navigator, 2.0, 0.5);
  test::drive(navigator, robot_, 60.0);
  ASSERT_GT(robot_.commands.size(), 20U);
  for (std::size_t i = 1; i < robot_.commands.size(); ++i)
    EXPECT_LE(std::abs(robot_.commands[i] - robot_.commands[i - 1]), 0.5 * 0.1 + 1e-9);
}

TEST_F(DwaNavigatorTest, PassesWaypoints) {
  mrpt::nav::TWaypointSequence waypoints;
  for (const auto& [x, y] : {std::pair{1.5, 0.0}, std::pair{1.5, 1.5}}) {
    mrpt::nav::TWaypoint waypoint(x, y, 0.3);
    waypoints.waypoints.push_back(waypoint);
  }
  waypoints.waypoints.front().allow_skip = false;
  navigator.navigateWaypoints(waypoints);
  for (int i = 0; i < 600 && !navigator.getWaypointNavStatus().final_goal_reached; ++i) {
    navigator.navigationStep();
    robot_.vehicle.simulateOneTimeStep(0.1);
  }
  const auto pose = robot_.vehicle.getCurrentGTPose();
  EXPECT_LT(std::hypot(pose.x - 1.5, pose.y - 1.5), 0.4);
  EXPECT_THAT(robot_.events, testing::HasSubstr("reached0"));
}

TEST_F(DwaNavigatorTest, StandsWhileSuspendedAndWhenCancelled) {
  test::navigateTo(navigator, 5.0, 0.0);
  test::drive(navigator, robot_, 2.0);
  navigator.suspend();
  test::drive(navigator, robot_, 1.0);
  for (int i = 0; i < 30; ++i) robot_.vehicle.simulateOneTimeStep(0.1);
  const double held = robot_.vehicle.getCurrentGTPose().x;
  EXPECT_NEAR(robot_.vehicle.getCurrentGTVelLocal().vx, 0.0, 1e-3);
  navigator.resume();
  test::drive(navigator, robot_, 3.0);
  EXPECT_GT(robot_.vehicle.getCurrentGTPose().x, held + 0.3);
  navigator.cancel();
  EXPECT_EQ(navigator.getCurrentState(), DwaNavigator::IDLE);
}

TEST_F(DwaNavigatorTest, AFailingRobotInterfaceEndsTheNavigation) {
  test::navigateTo(navigator, 5.0, 0.0);
  test::drive(navigator, robot_, 1.0);
  robot_.throwsNow = true;
  test::drive(navigator, robot_, 1.0);
  EXPECT_EQ(navigator.getCurrentState(), DwaNavigator::NAV_ERROR);
  EXPECT_THAT(robot_.events, testing::HasSubstr("error"));
  robot_.throwsNow = false;
  navigator.resetNavError();
  test::navigateTo(navigator, 1.0, 0.0);
  test::drive(navigator, robot_, 30.0);
  EXPECT_THAT(robot_.events, testing::EndsWith("end "));
}

TEST_F(DwaNavigatorTest, ARobotThatDoesNotKnowItsPoseEndsTheNavigation) {
  test::navigateTo(navigator, 5.0, 0.0);
  test::drive(navigator, robot_, 1.0);
  robot_.lost = true;
  test::drive(navigator, robot_, 0.5);
  EXPECT_EQ(navigator.getCurrentState(), DwaNavigator::NAV_ERROR);
}

TEST_F(DwaNavigatorTest, StandsWhenTheObstaclesAreOldOnes) {
  robot_.addWall(4.0, -1.0, 4.0, 1.0);
  test::navigateTo(navigator, 3.0, 0.0);
  test::drive(navigator, robot_, 3.0);
  ASSERT_GT(robot_.commands.back(), 0.3);
  robot_.frozen = true;
  test::drive(navigator, robot_, 3.0);  // half a second of grace, then braking at 0.5 m/s²
  EXPECT_EQ(robot_.commands.back(), 0.0);
  EXPECT_EQ(navigator.lastRecord().health, CycleRecord::Health::StaleSensor);
}

TEST_F(DwaNavigatorTest, ArrivesStanding) {
  test::navigateTo(navigator, 2.0, 0.0);
  test::drive(navigator, robot_, 60.0);
  ASSERT_EQ(robot_.events, "start end ");
  ASSERT_FALSE(robot_.speedsAtStop.empty());
  for (const double speed : robot_.speedsAtStop) EXPECT_LT(std::abs(speed), 0.05);
}

/** A robot with a laser of its own, which sees a wall at x = 2 that senseObstacles() does not know.
 */
class ScanningRobot : public test::PtgRobot, public SensorSource {
 public:
  void sense(SensorFrame& frame) override {
    const auto pose = vehicle.getCurrentGTPose();
    const auto range_m = [&pose](int bearing_deg) {
      const double ahead = std::cos(pose.phi + bearing_deg * M_PI / 180.0);
      const double range = (2.0 - pose.x) / ahead;
      return ahead > 0.1 && range < 5.0 ? range : 0.0;
    };
    frame.scans = {test::makeScan(vehicle.getTime(), range_m)};
  }
};

TEST_F(DwaNavigatorTest, HeedsTheScansOfARobotThatIsASensorSource) {
  ScanningRobot scanning;
  DwaNavigator its(scanning);
  its.setMinLoggingLevel(mrpt::system::LVL_ERROR);
  its.loadConfigFile(ini);
  test::navigateTo(its, 5.0, 0.0);
  test::drive(its, scanning, 6.0);
  EXPECT_EQ(its.lastRecord().beams, 181);
  EXPECT_GT(scanning.vehicle.getCurrentGTPose().x, 0.5);
  EXPECT_LT(scanning.vehicle.getCurrentGTPose().x, 1.8);
}

TEST_F(DwaNavigatorTest, WithoutConfigurationItFailsAndDoesNotCrash) {
  DwaNavigator fresh(robot_);
  fresh.setMinLoggingLevel(mrpt::system::LVL_ERROR);
  test::navigateTo(fresh, 1.0, 0.0);
  for (int i = 0; i < 3; ++i) fresh.navigationStep();
  EXPECT_FALSE(fresh.isRelativePointReachable({1.0, 0.0}));
  EXPECT_NE(fresh.getCurrentState(), DwaNavigator::NAVIGATING);
}

TEST_F(DwaNavigatorTest, NeedsItsConfiguration) {
  DwaNavigator fresh(robot_);
  fresh.setMinLoggingLevel(mrpt::system::LVL_ERROR);
  fresh.enableRethrowNavExceptions(true);
  test::navigateTo(fresh, 1.0, 0.0);
  EXPECT_THROW(fresh.navigationStep(), std::exception);
  ini.write("limits", "max_sped_mps", 1.0);
  EXPECT_THROW(fresh.loadConfigFile(ini), std::exception);
}

TEST_F(DwaNavigatorTest, OtherThreadsMayAskAndCancelAtAnyTime) {
  test::navigateTo(navigator, 50.0, 0.0);
  std::atomic<bool> done{false};
  std::thread other([&] {
    for (int i = 0; i < 200; ++i) {
      navigator.lastRecord();
      if (i % 50 == 49) navigator.cancel(), test::navigateTo(navigator, 50.0, 0.0);
    }
    done = true;
  });
  while (!done) {
    navigator.navigationStep();
    robot_.vehicle.simulateOneTimeStep(0.1);
  }
  other.join();
  EXPECT_EQ(navigator.getCurrentState(), DwaNavigator::NAVIGATING);
}

}  // namespace
}  // namespace bslnav
