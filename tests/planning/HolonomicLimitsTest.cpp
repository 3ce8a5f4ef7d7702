#include <bslnav/planning/DynamicWindow.h>
#include <bslnav/planning/RobotLimits.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "DwaGenerators.h"

namespace bslnav {
namespace {

using mrpt::math::TTwist2D;

constexpr double kPeriod_s = 0.1;
/** 0.05 m/s up and 0.2 down a period; 0.6 m/s to the side. */
constexpr RobotLimits kLimits{1.0, 1.0, 0.5, 2.0, 3.0, 0.3, 0.6};

double distance(const TTwist2D& a, const TTwist2D& b) {
  return std::hypot(a.vx - b.vx, a.vy - b.vy);
}
double speed(const TTwist2D& twist) { return std::hypot(twist.vx, twist.vy); }

TEST(HolonomicLimits, ACombinedChangeIsLimitedAsAVector) {
  const TTwist2D faster = limited({0.3, 0.4, 0.0}, {}, kLimits, kPeriod_s);
  EXPECT_NEAR(faster.vx, 0.6 * 0.05, 1e-12);
  EXPECT_NEAR(faster.vy, 0.8 * 0.05, 1e-12);
  const TTwist2D slower = brake({0.3, 0.4, 0.0}, kLimits, kPeriod_s);
  EXPECT_NEAR(slower.vx, 0.3 - 0.6 * 0.2, 1e-12);
  EXPECT_NEAR(slower.vy, 0.4 - 0.8 * 0.2, 1e-12);
}

TEST(HolonomicLimits, TurnsRoundWithTheAccelerationInWhatIsLeftOfThePeriodAfterTheStop) {
  // As forwards: 0.05 m/s are braked in a quarter of the period; three quarters of 0.05 m/s follow.
  const TTwist2D command = limited({0.0, -0.6, 0.0}, {0.0, 0.05, 0.0}, kLimits, kPeriod_s);
  EXPECT_NEAR(command.vy, -0.0375, 1e-12);
  EXPECT_EQ(command.vx, 0.0);
}

TEST(HolonomicLimits, TheTopSpeedIsThatOfTheVectorAndTheLateralOneItsOwn) {
  const TTwist2D diagonal = limited({1.0, 0.6, 0.0}, {0.8, 0.48, 0.0}, kLimits, 10.0);
  EXPECT_NEAR(speed(diagonal), 1.0, 1e-12);
  EXPECT_NEAR(diagonal.vy / diagonal.vx, 0.6, 1e-12);
  EXPECT_NEAR(limited({0.0, 5.0, 0.0}, {}, kLimits, 10.0).vy, 0.6, 1e-12);
}

TEST(HolonomicLimits, ARobotThatCannotMoveSidewaysIsNeverToldTo) {
  RobotLimits limits = kLimits;
  limits.maxLateralSpeed_mps = 0.0;
  EXPECT_EQ(limited({0.3, 0.4, 0.0}, {0.3, 0.1, 0.0}, limits, kPeriod_s).vy, 0.0);
  EXPECT_EQ(limited({0.3, 0.4, 0.0}, {0.3, 0.1, 0.0}, limits, kPeriod_s).vx, 0.3);
  EXPECT_EQ(commandBase({0.3, 0.1, 0.0}, {0.3, 0.2, 0.0}, limits).vy, 0.0);
  EXPECT_EQ(speedOf({0.3, 0.4, 0.0}, limits), 0.3);
  EXPECT_DOUBLE_EQ(speedOf({0.3, 0.4, 0.0}, kLimits), 0.5);
}

TEST(HolonomicLimits, CommandsGoOnFromTheLastOneAsFarAsTheBaseMayTrailIt) {
  RobotLimits limits;  // 0.5 m/s² for 0.3 s: 0.15 m/s
  limits.maxLateralSpeed_mps = 0.5;
  const auto near = commandBase({0.3, 0.1, 0.0}, {0.35, 0.2, 0.0}, limits);
  EXPECT_DOUBLE_EQ(near.vx, 0.35);
  EXPECT_DOUBLE_EQ(near.vy, 0.2);
  const auto far = commandBase({}, {0.3, 0.4, 0.0}, limits);
  EXPECT_NEAR(far.vx, 0.6 * 0.15, 1e-12);
  EXPECT_NEAR(far.vy, 0.8 * 0.15, 1e-12);
}

RC_GTEST_PROP(HolonomicLimitsLaw, CommandsKeepSpeedAndVectorAcceleration, ()) {
  const RobotLimits limits = test::anyHolonomicLimits();
  const TTwist2D current = test::anyTwist(limits);
  const TTwist2D wanted(test::any(-3.0, 3.0), test::any(-3.0, 3.0), test::any(-3.0, 3.0));
  const TTwist2D next = limited(wanted, current, limits, kPeriod_s);
  RC_ASSERT(speed(next) <= limits.maxSpeed_mps + 1e-9);
  RC_ASSERT(std::abs(next.vy) <= limits.maxLateralSpeed_mps + 1e-9);
  // On the straight line from one to the other: the time to slow down, and then to speed up.
  const double whole = distance(next, current);
  RC_PRE(whole > 1e-9);
  const double along = -(current.vx * (next.vx - current.vx) + current.vy * (next.vy - current.vy));
  const double slowing = std::min(whole, std::max(0.0, along / whole));
  RC_ASSERT(slowing / limits.deceleration_mps2 + (whole - slowing) / limits.acceleration_mps2 <=
            kPeriod_s + 1e-9);
  RC_ASSERT(distance(limited(next, current, limits, kPeriod_s), next) < 1e-9);
}

RC_GTEST_PROP(HolonomicLimitsLaw, WithoutLateralMotionItIsADifferentialDrive, ()) {
  const RobotLimits plain = test::anyLimits();
  RobotLimits holonomic = plain;
  holonomic.maxLateralSpeed_mps = 0.5;
  const TTwist2D current = test::anyTwist(plain), wanted = test::anyTwist(plain);
  const auto a = limited(wanted, current, plain, kPeriod_s);
  const auto b = limited(wanted, current, holonomic, kPeriod_s);
  RC_ASSERT((a.vx == b.vx && b.vy == 0.0 && a.omega == b.omega));
  RC_ASSERT(commandBase(current, wanted, plain) == commandBase(current, wanted, holonomic));
}

RC_GTEST_PROP(HolonomicLimitsLaw, TurningTheVelocitiesTurnsTheCommand, ()) {
  RobotLimits limits = test::anyHolonomicLimits();
  limits.maxLateralSpeed_mps = limits.maxSpeed_mps;  // the same in every direction
  TTwist2D current = test::anyTwist(limits), wanted = test::anyTwist(limits);
  TTwist2D command = limited(wanted, current, limits, kPeriod_s);
  const double turn = test::any(-M_PI, M_PI);
  for (TTwist2D* twist : {&current, &wanted, &command}) twist->rotate(turn);
  RC_ASSERT(distance(limited(wanted, current, limits, kPeriod_s), command) < 1e-9);
}

RC_GTEST_PROP(HolonomicLimitsLaw, BrakingStopsStraightInTheTimeThatTheLimitsNeed, ()) {
  const RobotLimits limits = test::anyHolonomicLimits();
  TTwist2D twist = test::anyTwist(limits);
  const double time_s = speed(twist) / limits.deceleration_mps2;
  for (int i = static_cast<int>(std::ceil(time_s / kPeriod_s - 1e-6)); i > 0; --i) {
    const TTwist2D next = brake(twist, limits, kPeriod_s);
    RC_ASSERT(std::abs(next.vx * twist.vy - next.vy * twist.vx) < 1e-9);
    RC_ASSERT(speed(next) <= speed(twist));
    twist = next;
  }
  RC_ASSERT(speed(twist) < 1e-6);
}

TEST(HolonomicWindow, BoundsTheLateralSpeedAsItCanBeReached) {
  const DynamicWindow window = dynamicWindow({0.5, 0.1, 0.0}, kLimits, 0.1, 1.0);
  EXPECT_DOUBLE_EQ(window.vMax, 0.55);
  EXPECT_NEAR(window.vyMax, 0.15, 1e-12);
  // 0.1 m/s are braked in half of the period; half of 0.05 m/s follows.
  EXPECT_NEAR(window.vyMin, -0.025, 1e-12);
  const DynamicWindow capped = dynamicWindow({0.1, 0.0, 0.0}, kLimits, 10.0, 0.2);
  EXPECT_DOUBLE_EQ(capped.vyMax, 0.2);
  EXPECT_DOUBLE_EQ(capped.vyMin, -0.2);
}

RC_GTEST_PROP(HolonomicWindowLaw, ItsVelocitiesCanBeReachedAndKeepTheCap, ()) {
  const RobotLimits limits = test::anyHolonomicLimits();
  const TTwist2D current = test::anyTwist(limits);
  const double cap = test::any(0.0, limits.maxSpeed_mps), window_s = test::any(0.02, 1.0);
  const DynamicWindow window = dynamicWindow(current, limits, window_s, cap);
  const TTwist2D velocity =
      withinWindow({test::any(window.vMin, window.vMax), test::any(window.vyMin, window.vyMax),
                    test::any(window.wMin, window.wMax)},
                   current, limits, window_s, cap);
  RC_ASSERT(distance(limited(velocity, current, limits, window_s), velocity) < 1e-9);
  RC_ASSERT(speed(velocity) <= std::max(cap, speed(current)) + 1e-9);
}

}  // namespace
}  // namespace bslnav
