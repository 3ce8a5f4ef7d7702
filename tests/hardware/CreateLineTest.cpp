// What a serial line does to the driver of a Create 2.

#include <bslnav/config/Error.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>

#include <fstream>

#include "CreateRig.h"

namespace bslnav::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string problemOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.kind() == Error::Kind::Run ? error.what() : "of the wrong kind";
  }
  return {};
}

TEST(CreateLine, APulledCableIsAnErrorThatNamesThePort) {
  CreateRig rig;
  rig.robot.pullCable();
  const auto state = [&] { return problemOf([&] { rig.base.state(); }); };
  ASSERT_TRUE(eventually([&] { return !state().empty(); }));
  const auto ofTheLine = AllOf(HasSubstr(rig.robot.path()), HasSubstr("the line"));
  EXPECT_THAT(state(), ofTheLine);
  EXPECT_THAT(problemOf([&] { rig.base.drive({}); }), ofTheLine);
  rig.base.stop();
}

TEST(CreateLine, InSilenceTheStampGetsOld) {
  CreateRig rig;
  const auto age_s = [&] { return mrpt::Clock::nowDouble() - rig.base.state().stamp_s; };
  EXPECT_TRUE(eventually([&] { return age_s() < 0.03; }));
  rig.robot.goSilent(true);
  EXPECT_TRUE(eventually([&] { return age_s() > 0.2; }));
  rig.robot.moved(1.0, 1.0);
  rig.robot.goSilent(false);
  EXPECT_TRUE(eventually([&] { return std::abs(rig.base.state().odometry.x - 1.0) < 1e-3; }));
  EXPECT_LT(age_s(), 5.0);
}

TEST(CreateLine, GarbageAndHalfFramesCostNothing) {
  CreateRig rig;
  const auto isAt = [&](double x_m) {
    return eventually([&, x_m] { return std::abs(rig.base.state().odometry.x - x_m) < 1e-3; });
  };
  rig.robot.sendGarbage(500);
  rig.robot.moved(0.1, 0.1);
  EXPECT_TRUE(isAt(0.1));
  rig.robot.halveNextFrame();
  rig.robot.moved(0.1, 0.1);
  EXPECT_TRUE(isAt(0.2));
  EXPECT_EQ(rig.base.badChecksums(), 0u);
}

TEST(CreateLine, ADamagedFrameIsDroppedAndCounted) {
  CreateRig rig;
  rig.robot.damageNextFrame();
  EXPECT_TRUE(eventually([&] { return rig.base.badChecksums() == 1; }));
  EXPECT_EQ(rig.base.state().odometry, mrpt::math::TPose2D());
}

TEST(CreateLine, WhereNoRobotAnswersIsAnError) {
  PseudoTerminal line;
  EXPECT_THAT(problemOf([&] { CreateBase base(createAt(line.path())); }),
              AllOf(HasSubstr(line.path()), HasSubstr("no robot answers")));
}

TEST(CreateLine, WhereNoPortIsIsAnError) {
  EXPECT_THAT(problemOf([] { CreateBase base(createAt("/dev/no_such_port")); }),
              HasSubstr("/dev/no_such_port: cannot be opened: No such file"));
  const std::string file = testing::TempDir() + "/bslnav_no_port";
  std::ofstream(file) << "no serial port";
  EXPECT_THAT(problemOf([&] { CreateBase base(createAt(file)); }),
              AllOf(HasSubstr(file + ": cannot be opened"), HasSubstr("expected a serial device")));
}

}  // namespace
}  // namespace bslnav::test
