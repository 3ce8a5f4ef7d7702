#include <bslnav/config/ConfigSection.h>
#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>

#include <cmath>

#include "TextBaseRig.h"

namespace bslnav::test {
namespace {

using Wire = TextBaseEmulator::Wire;

class TextBaseOver : public testing::TestWithParam<Wire> {
 protected:
  TextBaseEmulator emulator_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Wires, TextBaseOver, testing::Values(Wire::Serial, Wire::Tcp),
                         [](const auto& wire) {
                           return wire.param == Wire::Serial ? "Serial" : "Tcp";
                         });

TEST_P(TextBaseOver, TellsWhatTheBaseTells) {
  BaseState told;
  told.odometry = {1.5, -2.25, 7.0};
  told.twist = {0.3, -0.1, 0.2};
  told.halt = "bumper";
  told.mapFromRobot = {10.0, 20.0, -7.0};
  emulator_.setState(told);
  const double before_s = mrpt::Clock::nowDouble();
  TextBase base(at(emulator_.address()));
  const BaseState heard = base.state();
  EXPECT_DOUBLE_EQ(heard.odometry.x, 1.5);
  EXPECT_DOUBLE_EQ(heard.odometry.y, -2.25);
  EXPECT_NEAR(heard.odometry.phi, 7.0 - 2 * M_PI, 1e-9);
  EXPECT_DOUBLE_EQ(heard.twist.vx, 0.3);
  EXPECT_DOUBLE_EQ(heard.twist.vy, -0.1);
  EXPECT_DOUBLE_EQ(heard.twist.omega, 0.2);
  EXPECT_EQ(heard.halt, "bumper");
  ASSERT_TRUE(heard.mapFromRobot);
  EXPECT_DOUBLE_EQ(heard.mapFromRobot->x, 10.0);
  EXPECT_NEAR(heard.mapFromRobot->phi, 2 * M_PI - 7.0, 1e-9);
  EXPECT_GE(heard.stamp_s, before_s - 0.001);  // the base's clock has milliseconds
  EXPECT_LE(heard.stamp_s, mrpt::Clock::nowDouble());
  told.halt.clear();
  told.mapFromRobot.reset();
  emulator_.setState(told);
  EXPECT_TRUE(eventually([&] { return base.state().halt.empty() && !base.state().mapFromRobot; }));
}

TEST_P(TextBaseOver, DrivesAndStops) {
  TextBase base(at(emulator_.address()));
  EXPECT_TRUE(eventually([&] {
    base.drive({0.5, 0.1, -0.25});
    const auto command = emulator_.command();
    return command.vx == 0.5 && command.vy == 0.1 && command.omega == -0.25;
  }));
  EXPECT_FALSE(emulator_.stopped());
  base.stop();
  EXPECT_TRUE(eventually([&] { return emulator_.stopped(); }));
  EXPECT_EQ(emulator_.command().vx, 0.0);
}

TEST_P(TextBaseOver, StopsWhenItEnds) {
  {
    TextBase base(at(emulator_.address()));
    base.drive({0.5, 0.0, 0.0});
  }
  EXPECT_TRUE(eventually([&] { return emulator_.stopped(); }));
}

TEST_P(TextBaseOver, CanBeOpenedAgain) {
  { TextBase first(at(emulator_.address())); }
  TextBase second(at(emulator_.address()));
  EXPECT_TRUE(eventually([&] { return second.counts().states > 3; }));
}

// Its watchdog is the base's: nobody here takes the command back.
TEST_P(TextBaseOver, IsStoppedByItsWatchdog) {
  TextBaseParameters parameters = at(emulator_.address());
  parameters.watchdog_s = 0.1;
  TextBase base(parameters);
  EXPECT_TRUE(eventually([&] {
    base.drive({0.5, 0.0, 0.0});
    return emulator_.command().vx == 0.5;
  }));
  EXPECT_TRUE(eventually([&] { return emulator_.command().vx == 0.0; }));
  EXPECT_FALSE(emulator_.stopped());
}

TEST(TextBase, SaysHelloAgainToABaseThatIsStillStarting) {
  TextBaseEmulator emulator;
  emulator.missHellos(2);
  TextBase base(at(emulator.address()));
  EXPECT_GE(emulator.hellos(), 3);
}

TEST(TextBase, TakesNoVelocityThatIsNotFinite) {
  TextBaseEmulator emulator;
  TextBase base(at(emulator.address()));
  base.drive({0.5, 0.0, 0.0});
  EXPECT_THROW(base.drive({std::nan(""), 0.0, 0.0}), Error);
  EXPECT_TRUE(eventually([&] { return emulator.stopped(); }));
  EXPECT_THROW(base.drive({0.0, 0.0, INFINITY}), Error);
  EXPECT_EQ(emulator.refused(), 0);
}

TEST(TextBaseParameters, DescribeThemselves) {
  TextBaseParameters parameters;
  ConfigSection section("base", "");
  parameters.describe(section);
  ASSERT_EQ(section.fields().size(), 4U);
  section.fields()[0].read("tcp:robot:7000");
  EXPECT_EQ(parameters.address, "tcp:robot:7000");
  EXPECT_EQ(section.fields()[2].defaultText, "0.3");
}

}  // namespace
}  // namespace bslnav::test
