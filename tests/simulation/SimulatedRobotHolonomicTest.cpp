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

SimulatedRobotParameters holonomic(SimulatedRobotParameters parameters = {}) {
  parameters.kinematics = BaseKinematics::Holonomic;
  return parameters;
}

SimulatedRobotParameters ideal() { return holonomic(test::idealRobot()); }

void drive(SimulatedRobot& robot, const TTwist2D& command, double duration_s) {
  for (int i = 0; i < std::lround(duration_s / kStep_s); ++i) robot.advance(command, kStep_s);
}

double speedOf(const TTwist2D& twist) { return std::hypot(twist.vx, twist.vy); }

TEST(HolonomicRobot, DrivesSideways) {
  SimulatedRobot robot(ideal(), {1.0, 2.0, M_PI / 2}, 1);
  drive(robot, {0.3, 0.4, 0.0}, 4.0);
  // Heading 90°: forward is +y, left is -x. The first step ramps up, half of it is lost: 2.5 mm.
  EXPECT_NEAR(robot.pose().x, 1.0 - 1.6, 0.003);
  EXPECT_NEAR(robot.pose().y, 2.0 + 1.2, 0.003);
  EXPECT_NEAR(robot.pose().phi, M_PI / 2, 1e-12);
}

TEST(DiffDriveRobot, TakesNoNoticeOfALateralCommand) {
  SimulatedRobot plain(test::idealRobot(), {}, 1), told(test::idealRobot(), {}, 1);
  drive(plain, {0.5, 0.0, 0.3}, 2.0);
  drive(told, {0.5, 0.4, 0.3}, 2.0);
  EXPECT_EQ(told.pose().x, plain.pose().x);
  EXPECT_EQ(told.pose().y, plain.pose().y);
  EXPECT_EQ(told.twist().vy, 0.0);
}

TEST(HolonomicRobot, TurnsWhileItDrivesInAnyDirection) {
  // A velocity that is constant in the robot frame drives a circle: half way round it is one
  // diameter 2v/ω away, to the left of where it set out to.
  for (const double direction : {0.0, 0.5, M_PI / 2, M_PI, -2.0})
    for (const double turn : {M_PI / 4, -M_PI / 4}) {
      SimulatedRobot robot(ideal(), {}, 1);
      const TTwist2D command(0.5 * std::cos(direction), 0.5 * std::sin(direction), turn);
      drive(robot, command, 4.0);
      const double side = direction + std::copysign(M_PI / 2, turn);
      EXPECT_NEAR(robot.pose().x, 2 * 0.5 / (M_PI / 4) * std::cos(side), 0.01) << direction;
      EXPECT_NEAR(robot.pose().y, 2 * 0.5 / (M_PI / 4) * std::sin(side), 0.01) << direction;
      drive(robot, command, 4.0);
      EXPECT_NEAR(robot.pose().x, 0.0, 0.01) << direction;
      EXPECT_NEAR(robot.pose().y, 0.0, 0.01) << direction;
    }
}

TEST(HolonomicRobot, TurnsOnTheSpotWithoutMoving) {
  SimulatedRobot robot(ideal(), {1.0, 2.0, 0.0}, 1);
  drive(robot, {0.0, 0.0, 0.5}, 2.0);
  EXPECT_NEAR(robot.pose().phi, 1.0, 0.003);
  EXPECT_EQ(robot.pose().x, 1.0);
  EXPECT_EQ(robot.pose().y, 2.0);
}

TEST(HolonomicRobot, FollowsACommandWithTheLag) {
  auto parameters = ideal();
  parameters.lag_s = 0.2;
  SimulatedRobot robot(parameters, {}, 1);
  drive(robot, {0.6, -0.8, 0.0}, 0.2);
  EXPECT_NEAR(robot.twist().vx, 0.6 * (1.0 - std::exp(-1.0)), 1e-9);
  EXPECT_NEAR(robot.twist().vy, -0.8 * (1.0 - std::exp(-1.0)), 1e-9);
  // Distance after t: t - lag·(1 - exp(-t/lag)) = 0.2 · exp(-1), in the direction (0.6, -0.8)
  EXPECT_NEAR(robot.pose().x, 0.6 * 0.2 * std::exp(-1.0), 0.002);
  EXPECT_NEAR(robot.pose().y, -0.8 * 0.2 * std::exp(-1.0), 0.002);
}

TEST(HolonomicRobot, StopsWithinTheBrakingDistanceInTheDirectionItDrove) {
  auto parameters = holonomic();  // lag 0.05 s
  parameters.maxDeceleration_mps2 = 1.0;
  SimulatedRobot robot(parameters, {}, 1);
  drive(robot, {0.3, 0.4, 0.0}, 3.0);
  const auto from = robot.pose();
  drive(robot, {}, 3.0);
  // v²/(2a) = 0.125 m at the limit, then the lag's tail a·lag²/2 = 1.25 mm; one substep of 5 mm.
  EXPECT_NEAR(robot.pose().x - from.x, 0.6 * 0.12625, 0.005);
  EXPECT_NEAR(robot.pose().y - from.y, 0.8 * 0.12625, 0.005);
  EXPECT_EQ(speedOf(robot.twist()), 0.0);
  const auto stopped = robot.pose();
  drive(robot, {}, 1.0);
  EXPECT_EQ(robot.pose().x, stopped.x);
  EXPECT_EQ(robot.pose().y, stopped.y);
}

TEST(HolonomicRobot, TheLimitsHoldForTheVector) {
  auto parameters = holonomic();
  parameters.lag_s = 0.0;
  SimulatedRobot robot(parameters, {}, 1);
  drive(robot, {2.0, 2.0, 0.0}, 0.5);
  EXPECT_NEAR(speedOf(robot.twist()), 0.25, 1e-9);  // 0.5 m/s² for 0.5 s
  EXPECT_NEAR(robot.twist().vx, robot.twist().vy, 1e-12);
  drive(robot, {2.0, 2.0, 0.0}, 5.0);
  EXPECT_NEAR(speedOf(robot.twist()), 1.0, 1e-9);
}

RC_GTEST_PROP(HolonomicRobot, EveryStepKeepsTheLimits, ()) {
  auto parameters = holonomic();
  parameters.maxDeceleration_mps2 = 0.8;
  SimulatedRobot robot(parameters, {}, 1);
  const auto number = [](int limit) { return *rc::gen::inRange(-limit, limit) / 100.0; };
  for (int k = 0; k < 20; ++k) {
    const TTwist2D command(number(200), number(200), number(400));
    for (int i = 0; i < 10; ++i) {
      const auto before = robot.twist();
      robot.advance(command, kStep_s);
      const auto after = robot.twist();
      const double limit = speedOf(after) < speedOf(before) ? 0.8 : 0.5;
      const double change = std::hypot(after.vx - before.vx, after.vy - before.vy);
      RC_ASSERT(change <= limit * kStep_s + 1e-6);
      RC_ASSERT(std::abs(after.omega - before.omega) <= 2.0 * kStep_s + 1e-6);
      RC_ASSERT(speedOf(after) <= parameters.maxSpeed_mps + 1e-6);
      RC_ASSERT(std::abs(after.omega) <= parameters.maxYawRate_radps + 1e-6);
    }
  }
}

RC_GTEST_PROP(HolonomicRobot, ComesToEveryVelocityWithinItsLimits, ()) {
  const auto number = [](int limit) { return *rc::gen::inRange(-limit, limit) / 100.0; };
  SimulatedRobot robot(holonomic(), {}, 1);
  drive(robot, {number(70), number(70), number(200)}, 3.0);
  const TTwist2D wanted(number(70), number(70), number(200));
  drive(robot, wanted, 6.0);  // 2 m/s of change at 0.5 m/s², and the lag
  RC_ASSERT(std::abs(robot.twist().vx - wanted.vx) < 1e-6);
  RC_ASSERT(std::abs(robot.twist().vy - wanted.vy) < 1e-6);
  RC_ASSERT(std::abs(robot.twist().omega - wanted.omega) < 1e-6);
}

RC_GTEST_PROP(HolonomicRobot, TurningTheCommandTurnsTheMotion, ()) {
  const double turn = *rc::gen::inRange(-314, 314) / 100.0;
  SimulatedRobot plain(holonomic(), {}, 1), turned(holonomic(), {}, 1);
  for (int k = 0; k < 5; ++k) {
    const double vx = *rc::gen::inRange(-80, 80) / 100.0, vy = *rc::gen::inRange(-80, 80) / 100.0;
    TTwist2D command(vx, vy, *rc::gen::inRange(-200, 200) / 100.0);
    drive(plain, command, 0.5);
    command.rotate(turn);
    drive(turned, command, 0.5);
  }
  const auto &a = plain.pose(), &b = turned.pose();
  const double c = std::cos(turn), s = std::sin(turn);
  RC_ASSERT(std::hypot(c * a.x - s * a.y - b.x, s * a.x + c * a.y - b.y) < 1e-4);
}

TEST(HolonomicRobot, CommandTakesEffectAfterTheLatency) {
  auto parameters = ideal();
  parameters.commandLatency_s = 0.1;
  SimulatedRobot robot(parameters, {}, 1);
  drive(robot, {0.0, 1.0, 0.0}, 0.1);
  EXPECT_EQ(robot.twist().vy, 0.0);
  drive(robot, {}, 0.05);
  EXPECT_EQ(robot.twist().vy, 1.0);  // the first command, still on its way
  drive(robot, {}, 0.06);
  EXPECT_EQ(robot.twist().vy, 0.0);
}

TEST(HolonomicRobot, OdometryWithoutNoiseEqualsTheTruth) {
  SimulatedRobot robot(ideal(), {1.0, 2.0, 0.5}, 1);
  drive(robot, {0.3, -0.4, 0.7}, 5.0);
  EXPECT_NEAR(robot.odometry().x, robot.pose().x, 1e-9);
  EXPECT_NEAR(robot.odometry().y, robot.pose().y, 1e-9);
  EXPECT_NEAR(robot.odometry().phi, robot.pose().phi, 1e-9);
}

TEST(HolonomicRobot, OdometryErrorLiesAlongTheWayAndHasTheDeviationAskedFor) {
  auto parameters = ideal();
  parameters.odometryTranslationStd_m = 0.02;
  double squares = 0.0;
  constexpr int kRuns = 400;
  for (std::uint64_t seed = 0; seed < kRuns; ++seed) {
    SimulatedRobot robot(parameters, {}, seed);
    drive(robot, {0.0, 1.0, 0.0}, 1.0);
    squares += std::pow(robot.odometry().y - robot.pose().y, 2);
    EXPECT_NEAR(robot.odometry().x, robot.pose().x, 1e-9);
  }
  // After 1 m the deviation is 0.02 m, known from 400 runs to 0.02/sqrt(800) = 0.0007; 4 of them.
  EXPECT_NEAR(std::sqrt(squares / kRuns), 0.02, 0.0028);
}

TEST(HolonomicRobot, StandingStillAddsNoOdometryError) {
  SimulatedRobot robot(holonomic(), {1.0, 2.0, 0.5}, 1);
  drive(robot, {}, 1.0);
  EXPECT_EQ(robot.odometry().x, 1.0);
  EXPECT_EQ(robot.odometry().y, 2.0);
  EXPECT_EQ(robot.odometry().phi, 0.5);
}

TEST(HolonomicRobot, TheSameSeedGivesTheSameBits) {
  SimulatedRobot a(holonomic(), {}, 7), b(holonomic(), {}, 7), other(holonomic(), {}, 8);
  for (SimulatedRobot* robot : {&a, &b, &other}) drive(*robot, {0.5, -0.3, 0.4}, 3.0);
  EXPECT_EQ(a.pose().x, b.pose().x);
  EXPECT_EQ(a.odometry().y, b.odometry().y);
  EXPECT_EQ(a.odometry().phi, b.odometry().phi);
  EXPECT_NE(a.odometry().y, other.odometry().y);
}

TEST(HolonomicRobot, CommandThatIsNotANumberIsRefused) {
  SimulatedRobot robot(holonomic(), {}, 1);
  EXPECT_THROW(robot.advance({0.0, std::numeric_limits<double>::quiet_NaN(), 0.0}, kStep_s), Error);
}

}  // namespace
}  // namespace bslnav
