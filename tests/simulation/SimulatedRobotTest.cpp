#include <bslnav/config/Error.h>
#include <bslnav/simulation/SimulatedRobot.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "TestWorld.h"

namespace bslnav {
namespace {

using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;

constexpr double kStep_s = 0.01;

void drive(SimulatedRobot& robot, const TTwist2D& command, double duration_s) {
  for (int i = 0; i < std::lround(duration_s / kStep_s); ++i) robot.advance(command, kStep_s);
}

TEST(SimulatedRobot, DrivesTheCommandedDistanceInTheCommandedTime) {
  SimulatedRobot robot(test::idealRobot(), {1.0, 2.0, M_PI / 2}, 1);
  drive(robot, {0.5, 0.0, 0.0}, 4.0);
  EXPECT_NEAR(robot.pose().x, 1.0, 1e-9);
  EXPECT_NEAR(robot.pose().y, 4.0, 0.001);  // MRPT's model starts moving a period (0.5 ms) late
}

TEST(SimulatedRobot, DrivesACircleBackToItsStart) {
  SimulatedRobot robot(test::idealRobot(), {0.0, 0.0, 0.0}, 1);
  drive(robot, {0.5, 0.0, M_PI / 4}, 4.0);
  EXPECT_NEAR(robot.pose().y, 2 * 0.5 / (M_PI / 4), 0.002);  // half way: the diameter, 2v/ω
  drive(robot, {0.5, 0.0, M_PI / 4}, 4.0);
  EXPECT_NEAR(robot.pose().x, 0.0, 0.003);
  EXPECT_NEAR(robot.pose().y, 0.0, 0.003);
}

TEST(SimulatedRobot, FollowsACommandWithTheLag) {
  auto parameters = test::idealRobot();
  parameters.lag_s = 0.2;
  SimulatedRobot robot(parameters, {}, 1);
  drive(robot, {1.0, 0.0, 1.0}, 0.2);
  EXPECT_NEAR(robot.twist().vx, 1.0 - std::exp(-1.0), 1e-9);
  EXPECT_NEAR(robot.twist().omega, 1.0 - std::exp(-1.0), 1e-9);
  // Distance after t: t - lag·(1 - exp(-t/lag)) = 0.2 · exp(-1)
  EXPECT_NEAR(robot.pose().x, 0.2 * std::exp(-1.0), 0.002);
}

TEST(SimulatedRobot, StopsWithinTheBrakingDistance) {
  SimulatedRobotParameters parameters;  // lag 0.05 s
  parameters.maxDeceleration_mps2 = 1.0;
  SimulatedRobot robot(parameters, {0.0, 0.0, 0.0}, 1);
  drive(robot, {0.5, 0.0, 0.0}, 3.0);
  const double from = robot.pose().x;
  drive(robot, {0.0, 0.0, 0.0}, 3.0);
  // v²/(2a) = 0.125 m at the limit, then the lag's tail a·lag²/2 = 1.25 mm; one substep of 5 mm.
  EXPECT_NEAR(robot.pose().x - from, 0.12625, 0.005);
  EXPECT_EQ(robot.twist().vx, 0.0);
}

TEST(SimulatedRobot, SpeedsUpAtTheLimit) {
  SimulatedRobotParameters parameters;
  parameters.lag_s = 0.0;
  SimulatedRobot robot(parameters, {}, 1);
  drive(robot, {1.0, 0.0, 2.0}, 0.5);
  EXPECT_NEAR(robot.twist().vx, 0.25, 1e-9);    // 0.5 m/s² for 0.5 s
  EXPECT_NEAR(robot.twist().omega, 1.0, 1e-9);  // 2 rad/s² for 0.5 s
}

RC_GTEST_PROP(SimulatedRobot, EveryStepKeepsTheLimits, ()) {
  SimulatedRobotParameters parameters;
  parameters.maxDeceleration_mps2 = 0.8;
  SimulatedRobot robot(parameters, {}, 1);
  for (int k = 0; k < 20; ++k) {
    const TTwist2D command(*rc::gen::inRange(-200, 200) / 100.0, 0.0,
                           *rc::gen::inRange(-400, 400) / 100.0);
    for (int i = 0; i < 10; ++i) {
      const auto before = robot.twist();
      robot.advance(command, kStep_s);
      const auto after = robot.twist();
      const bool slower = std::abs(after.vx) < std::abs(before.vx);
      RC_ASSERT(std::abs(after.vx - before.vx) <= (slower ? 0.8 : 0.5) * kStep_s + 1e-6);
      RC_ASSERT(std::abs(after.omega - before.omega) <= 2.0 * kStep_s + 1e-6);
      RC_ASSERT(std::abs(after.vx) <= parameters.maxSpeed_mps + 1e-6);
      RC_ASSERT(std::abs(after.omega) <= parameters.maxYawRate_radps + 1e-6);
    }
  }
}

TEST(SimulatedRobot, TruePoseMovesAsTheTwistSays) {
  SimulatedRobot robot({}, {}, 1);
  double distance = 0.0;
  for (int i = 0; i < 300; ++i) {
    robot.advance({i < 150 ? 0.6 : -0.2, 0.0, 0.0}, kStep_s);
    distance += robot.twist().vx * kStep_s;
  }
  EXPECT_NEAR(robot.pose().x, distance, 0.005);
}

TEST(SimulatedRobot, CommandTakesEffectAfterTheLatency) {
  auto parameters = test::idealRobot();
  parameters.commandLatency_s = 0.1;
  SimulatedRobot robot(parameters, {}, 1);
  drive(robot, {1.0, 0.0, 0.0}, 0.1);
  EXPECT_EQ(robot.twist().vx, 0.0);
  drive(robot, {0.0, 0.0, 0.0}, 0.05);
  EXPECT_EQ(robot.twist().vx, 1.0);  // the first command, still on its way
  drive(robot, {0.0, 0.0, 0.0}, 0.06);
  EXPECT_EQ(robot.twist().vx, 0.0);
}

TEST(SimulatedRobot, OdometryWithoutNoiseEqualsTheTruth) {
  SimulatedRobot robot(test::idealRobot(), {1.0, 2.0, 0.5}, 1);
  drive(robot, {0.5, 0.0, 0.7}, 5.0);
  EXPECT_NEAR(robot.odometry().x, robot.pose().x, 1e-9);
  EXPECT_NEAR(robot.odometry().y, robot.pose().y, 1e-9);
  EXPECT_NEAR(robot.odometry().phi, robot.pose().phi, 1e-9);
}

TEST(SimulatedRobot, OdometryErrorHasTheDeviationAskedFor) {
  auto parameters = test::idealRobot();
  parameters.odometryTranslationStd_m = 0.02;
  double squares = 0.0;
  constexpr int kRuns = 400;
  for (std::uint64_t seed = 0; seed < kRuns; ++seed) {
    SimulatedRobot robot(parameters, {}, seed);
    drive(robot, {1.0, 0.0, 0.0}, 1.0);
    squares += std::pow(robot.odometry().x - robot.pose().x, 2);
  }
  // After 1 m the deviation is 0.02 m, known from 400 runs to 0.02/sqrt(800) = 0.0007; 4 of them.
  EXPECT_NEAR(std::sqrt(squares / kRuns), 0.02, 0.0028);
}

TEST(SimulatedRobot, StandingStillAddsNoOdometryError) {
  SimulatedRobot robot({}, {1.0, 2.0, 0.5}, 1);
  drive(robot, {}, 1.0);
  EXPECT_EQ(robot.odometry().x, 1.0);
  EXPECT_EQ(robot.odometry().phi, 0.5);
}

TEST(SimulatedRobot, CommandThatIsNotANumberIsRefused) {
  SimulatedRobot robot({}, {}, 1);
  EXPECT_THROW(robot.advance({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}, kStep_s), Error);
}

TEST(SimulatedRobot, LimitOfZeroIsRefused) {
  SimulatedRobotParameters parameters;
  parameters.maxDeceleration_mps2 = 0.0;
  EXPECT_THROW(SimulatedRobot(parameters, {}, 1), Error);
}

}  // namespace
}  // namespace bslnav
