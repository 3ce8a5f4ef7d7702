#include <bslnav/planning/DynamicWindow.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "DwaGenerators.h"

namespace bslnav {
namespace {

constexpr RobotLimits kLimits{1.0, 1.0, 0.5, 2.0, 3.0};  // 0.05 up, 0.2 down, 0.3 rad/s a period

TEST(DynamicWindow, IsWhatOnePeriodCanReach) {
  const DynamicWindow window = dynamicWindow({0.5, 0.0, 0.1}, kLimits, 0.1, 1.0);
  EXPECT_DOUBLE_EQ(window.vMin, 0.3);
  EXPECT_DOUBLE_EQ(window.vMax, 0.55);
  EXPECT_DOUBLE_EQ(window.wMin, -0.2);
  EXPECT_DOUBLE_EQ(window.wMax, 0.4);
}

TEST(DynamicWindow, EndsAtZeroAndAtTheLimits) {
  const DynamicWindow slow = dynamicWindow({0.1, 0.0, 0.0}, kLimits, 0.1, 1.0);
  EXPECT_EQ(slow.vMin, 0.0);
  const DynamicWindow fast = dynamicWindow({0.98, 0.0, 0.9}, kLimits, 0.1, 1.0);
  EXPECT_EQ(fast.vMax, 1.0);
  EXPECT_EQ(fast.wMax, 1.0);
}

TEST(DynamicWindow, BrakesToACapAsFastAsItMay) {
  const DynamicWindow window = dynamicWindow({0.8, 0.0, 0.0}, kLimits, 0.1, 0.1);
  EXPECT_DOUBLE_EQ(window.vMin, 0.6);
  EXPECT_DOUBLE_EQ(window.vMax, 0.6);
}

TEST(DynamicWindow, StopsARobotThatRollsBackwards) {
  const DynamicWindow window = dynamicWindow({-0.5, 0.0, 0.0}, kLimits, 0.1, 1.0);
  EXPECT_DOUBLE_EQ(window.vMin, -0.3);  // deceleration, not acceleration
  EXPECT_DOUBLE_EQ(window.vMax, -0.3);
}

RC_GTEST_PROP(DynamicWindowLaw, StaysWithinTheLimitsAndWhatCanBeReached, ()) {
  const RobotLimits limits = test::anyLimits();
  const auto current = test::anyTwist(limits);
  const double cap = test::any(0.0, limits.maxSpeed_mps), period_s = test::any(0.02, 0.5);
  const DynamicWindow window = dynamicWindow(current, limits, period_s, cap);
  RC_ASSERT(window.vMin <= window.vMax && window.wMin <= window.wMax);
  RC_ASSERT((window.wMin >= -limits.maxYawRate_radps && window.wMax <= limits.maxYawRate_radps));
  for (const double v : {window.vMin, window.vMax}) {
    RC_ASSERT(std::abs(v) <= limits.maxSpeed_mps);
    const auto command = limited({v, 0.0, window.wMin}, current, limits, period_s);
    RC_ASSERT(std::abs(command.vx - v) < 1e-12);
    RC_ASSERT(std::abs(command.omega - window.wMin) < 1e-12);
  }
}

RC_GTEST_PROP(SampleLaw, SamplesAscendFromEndToEndAndHoldZero, ()) {
  const double low = test::any(-2.0, 1.0), high = low + test::any(0.001, 3.0);
  const int n = *rc::gen::inRange(2, 60);
  bool holdsZero = false;
  for (int i = 0; i < n; ++i) {
    const double value = sampleOf(low, high, i, n);
    RC_ASSERT((value >= low - 1e-12 && value <= high));
    if (i > 0) RC_ASSERT(value >= sampleOf(low, high, i - 1, n));
    holdsZero = holdsZero || value == 0.0;
  }
  RC_ASSERT(holdsZero == (low <= 0.0 && high >= 0.0));
}

TEST(Sample, OfOneIsZeroOrTheHighEnd) {
  EXPECT_EQ(sampleOf(-1.0, 2.0, 0, 1), 0.0);
  EXPECT_EQ(sampleOf(1.0, 2.0, 0, 1), 2.0);
}

}  // namespace
}  // namespace bslnav
