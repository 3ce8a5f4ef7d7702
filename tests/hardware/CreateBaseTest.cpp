#include <bslnav/config/Error.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "CreateRig.h"

namespace bslnav::test {
namespace {

using mrpt::math::TTwist2D;
using testing::HasSubstr;

const TTwist2D kForward{0.2, 0.0, 0.0}, kBackward{-0.1, 0.0, 0.0};

TEST(CreateBase, DrivesTheWheels) {
  CreateRig rig;
  EXPECT_EQ(rig.robot.mode(), CreateRobot::Safe);
  // 0.2 m/s -+ 0.05875 m/s, in whole mm/s
  ASSERT_TRUE(rig.driveUntil({0.2, 0.0, 0.5}, [&] { return !rig.stands(); }));
  EXPECT_NEAR(rig.robot.wheels().left_mps, 0.141, 1e-9);
  EXPECT_NEAR(rig.robot.wheels().right_mps, 0.259, 1e-9);
}

TEST(CreateBase, OdometryFollowsTheWheels) {
  CreateRig rig;
  EXPECT_EQ(rig.base.state().odometry, mrpt::math::TPose2D());
  const auto x = [&] { return rig.base.state().odometry.x; };
  const auto heading = [&] { return rig.base.state().odometry.phi; };
  rig.robot.moved(0.5, 0.5);
  EXPECT_TRUE(eventually([&] { return std::abs(x() - 0.5) < 1e-3; }));  // a count is 0.44 mm
  const double quarter_m = 0.235 / 2.0 * M_PI / 2.0;
  rig.robot.moved(-quarter_m, quarter_m);
  EXPECT_TRUE(eventually([&] { return std::abs(heading() - M_PI / 2.0) < 1e-2; }));
}

TEST(CreateBase, TwistIsThatOfTheWheelsAndZeroWhenTheyStand) {
  CreateRig rig;
  const auto vx = [&] { return rig.base.state().twist.vx; };
  EXPECT_TRUE(eventually([&] { return vx() > 0.05; }, [&] { rig.robot.moved(1e-3, 1e-3); }));
  EXPECT_TRUE(eventually([&] { return vx() == 0.0; }));
}

TEST(CreateBase, ABumpStopsItAndItBacksOff) {
  CreateRig rig;
  ASSERT_TRUE(rig.driveUntil(kForward, [&] { return rig.speed_mps() > 0.0; }));
  rig.robot.setBump(true);
  ASSERT_TRUE(rig.driveUntil(kForward, [&] { return rig.stands(); }));
  EXPECT_EQ(rig.base.state().halt, "bump ahead");
  ASSERT_TRUE(rig.driveUntil(kBackward, [&] { return rig.speed_mps() < 0.0; }));
  rig.robot.setBump(false);
  ASSERT_TRUE(rig.driveUntil(kForward, [&] { return rig.speed_mps() > 0.0; }));
  EXPECT_EQ(rig.base.state().halt, "");
}

TEST(CreateBase, ACliffStopsItUntilItIsOver) {
  CreateRig rig;
  ASSERT_TRUE(rig.driveUntil(kForward, [&] { return rig.speed_mps() > 0.0; }));
  rig.robot.setCliff(true);
  ASSERT_TRUE(rig.driveUntil(kForward, [&] { return rig.base.state().halt == "cliff"; }));
  EXPECT_TRUE(rig.stands());
  const auto drive = rig.robot.lastDrive().count;  // the driver itself orders zero, too
  ASSERT_TRUE(rig.driveUntil(kForward, [&] { return rig.robot.lastDrive().count > drive + 1; }));
  EXPECT_EQ(rig.robot.lastDrive().wheels.left_mps, 0.0);
  rig.robot.setCliff(false);
  ASSERT_TRUE(rig.driveUntil(kForward, [&] { return rig.speed_mps() > 0.0; }));
  EXPECT_EQ(rig.robot.mode(), CreateRobot::Safe);
}

TEST(CreateBase, AWheelDropStopsItUntilItIsOver) {
  CreateRig rig;
  ASSERT_TRUE(rig.driveUntil(kForward, [&] { return rig.speed_mps() > 0.0; }));
  rig.robot.setWheelDrop(true);
  const auto told = [&] { return !rig.base.state().halt.empty(); };
  ASSERT_TRUE(rig.driveUntil(kBackward, told));
  EXPECT_THAT(rig.base.state().halt, HasSubstr("wheel drop"));
  EXPECT_TRUE(rig.stands());
  rig.robot.setWheelDrop(false);
  EXPECT_TRUE(rig.driveUntil(kForward, [&] { return rig.speed_mps() > 0.0; }));
}

TEST(CreateBase, StopStops) {
  CreateEmulator robot;
  CreateBase base(patientCreateAt(robot.path()));
  base.drive(kForward);
  ASSERT_TRUE(eventually([&] { return robot.wheels().left_mps > 0.0; }));
  base.stop();
  EXPECT_TRUE(eventually([&] { return robot.wheels().left_mps == 0.0; }));
}

TEST(CreateBase, StopsWhenItGoes) {
  CreateEmulator robot;
  std::optional<CreateBase> base(patientCreateAt(robot.path()));
  base->drive(kForward);
  ASSERT_TRUE(eventually([&] { return robot.wheels().left_mps > 0.0; }));
  base.reset();
  EXPECT_TRUE(eventually([&] { return robot.wheels().left_mps == 0.0; }));
}

TEST(CreateBase, StopsWhenNoCommandComes) {
  CreateRig rig;
  const auto before = std::chrono::steady_clock::now();
  rig.base.drive(kForward);
  ASSERT_TRUE(eventually([&] { return !rig.stands(); }));
  ASSERT_TRUE(eventually([&] { return rig.stands(); }));
  const std::chrono::duration<double> after = rig.robot.lastDrive().at - before;
  EXPECT_GE(after.count(), CreateParameters().commandTimeout_s);
}

TEST(CreateBase, ACommandThatIsNotFiniteStopsIt) {
  CreateRig rig;
  ASSERT_TRUE(rig.driveUntil(kForward, [&] { return !rig.stands(); }));
  EXPECT_THROW(rig.base.drive({std::nan(""), 0.0, 0.0}), Error);
  EXPECT_TRUE(eventually([&] { return rig.stands(); }));
}

}  // namespace
}  // namespace bslnav::test
