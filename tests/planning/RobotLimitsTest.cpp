#include <bslnav/planning/RobotLimits.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <deque>

#include "DwaGenerators.h"

namespace bslnav {
namespace {

using mrpt::math::TTwist2D;

constexpr double kPeriod_s = 0.1;
constexpr RobotLimits kLimits{1.0, 1.0, 0.5, 2.0, 3.0};  // 0.05 up, 0.2 down, 0.3 rad/s a period

TEST(RobotLimits, SpeedsUpByTheAccelerationAndBrakesByTheDeceleration) {
  EXPECT_DOUBLE_EQ(limited({1.0, 0.0, 0.0}, {0.5, 0.0, 0.0}, kLimits, kPeriod_s).vx, 0.55);
  EXPECT_DOUBLE_EQ(limited({0.0, 0.0, 0.0}, {0.5, 0.0, 0.0}, kLimits, kPeriod_s).vx, 0.3);
  EXPECT_DOUBLE_EQ(limited({-1.0, 0.0, 0.0}, {-0.5, 0.0, 0.0}, kLimits, kPeriod_s).vx, -0.55);
  EXPECT_DOUBLE_EQ(limited({0.0, 0.0, 0.0}, {-0.5, 0.0, 0.0}, kLimits, kPeriod_s).vx, -0.3);
}

TEST(RobotLimits, ReversesWithTheAccelerationInWhatIsLeftOfThePeriodAfterTheStop) {
  // 0.05 m/s are braked in a quarter of the period; three quarters of 0.05 m/s follow.
  EXPECT_DOUBLE_EQ(limited({-1.0, 0.0, 0.0}, {0.05, 0.0, 0.0}, kLimits, kPeriod_s).vx, -0.0375);
  EXPECT_DOUBLE_EQ(limited({1.0, 0.0, 0.0}, {-0.05, 0.0, 0.0}, kLimits, kPeriod_s).vx, 0.0375);
  EXPECT_DOUBLE_EQ(limited({-1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, kLimits, kPeriod_s).vx, -0.05);
}

TEST(RobotLimits, CommandsGoOnFromTheLastOneAsFarAsTheBaseMayTrailIt) {
  RobotLimits limits;  // 0.5 m/s^2 and 2 rad/s^2 for 0.3 s: 0.15 m/s and 0.6 rad/s
  const auto near = commandBase({0.3, 0.0, 0.5}, {0.4, 0.0, 0.0}, limits);
  EXPECT_DOUBLE_EQ(near.vx, 0.4);
  EXPECT_DOUBLE_EQ(near.omega, 0.0);
  const auto far = commandBase({0.0, 0.0, -1.0}, {0.5, 0.0, 1.0}, limits);
  EXPECT_DOUBLE_EQ(far.vx, 0.15);
  EXPECT_DOUBLE_EQ(far.omega, -0.4);
}

TEST(RobotLimits, ABaseThatFollowsLateStopsWithinItsLatencyAndItsBrakingDistance) {
  const RobotLimits limits;
  TTwist2D last{0.5, 0.0, 0.0};
  std::deque<TTwist2D> onTheWay{last, last};  // two periods of 0.1 s
  double distance_m = 0.0;
  for (int i = 0; i < 40; ++i) {
    const TTwist2D measured = onTheWay.front();
    distance_m += 0.1 * measured.vx;
    onTheWay.pop_front();
    last = brake(commandBase(measured, last, limits), limits, 0.1);
    onTheWay.push_back(last);
  }
  EXPECT_EQ(last.vx, 0.0);
  // 0.5 m/s * 0.2 s + (0.5 m/s)^2 / (2 * 0.5 m/s^2) = 0.35 m, and at most one period more
  EXPECT_LE(distance_m, 0.35 + 0.05);
}

TEST(RobotLimits, TurnsByTheYawAcceleration) {
  EXPECT_DOUBLE_EQ(limited({0.0, 0.0, -1.0}, {0.0, 0.0, 0.1}, kLimits, kPeriod_s).omega, -0.2);
}

TEST(RobotLimits, LeadsARobotThatIsTooFastBackAsFastAsItMay) {
  const TTwist2D command = limited({5.0, 0.0, 5.0}, {1.5, 0.0, 2.0}, kLimits, kPeriod_s);
  EXPECT_DOUBLE_EQ(command.vx, 1.3);
  EXPECT_DOUBLE_EQ(command.omega, 1.7);
}

RC_GTEST_PROP(RobotLimitsLaw, WhatCanBeReachedIsCommandedAsItIs, ()) {
  const RobotLimits limits = test::anyLimits();
  const TTwist2D current = test::anyTwist(limits), wanted = test::anyTwist(limits);
  const TTwist2D first = limited(wanted, current, limits, kPeriod_s);
  const TTwist2D again = limited(first, current, limits, kPeriod_s);
  RC_ASSERT(again.vx == first.vx && again.omega == first.omega);
}

RC_GTEST_PROP(RobotLimitsLaw, BrakingStopsInTheTimeThatTheLimitsNeed, ()) {
  const RobotLimits limits = test::anyLimits();
  TTwist2D twist = test::anyTwist(limits);
  const double time_s = std::max(std::abs(twist.vx) / limits.deceleration_mps2,
                                 std::abs(twist.omega) / limits.yawAcceleration_radps2);
  const int periods = static_cast<int>(std::ceil(time_s / kPeriod_s - 1e-6));
  for (int i = 0; i < periods; ++i) {
    const TTwist2D next = brake(twist, limits, kPeriod_s);
    RC_ASSERT(std::abs(next.vx) <= std::abs(twist.vx));  // never past zero
    RC_ASSERT(next.vx * twist.vx >= 0.0);
    twist = next;
  }
  RC_ASSERT(std::abs(twist.vx) < 1e-6);
  RC_ASSERT(std::abs(twist.omega) < 1e-6);
}

}  // namespace
}  // namespace bslnav
