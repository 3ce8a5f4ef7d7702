#include <bslnav/navigation/InPlaceRotation.h>
#include <gtest/gtest.h>
#include <mrpt/math/wrap2pi.h>

#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;

constexpr double kPeriod_s = 0.1;
constexpr RobotLimits kLimits{0.5, 1.0, 0.5, 0.5, 2.0};

TEST(InPlaceRotation, TurnsToEveryHeadingWithoutOvershootingAndInTheTimeItNeeds) {
  for (const double wanted : {0.02, 0.3, 1.0, 2.5, 3.1, -0.1, -1.7}) {
    double heading = 0.0;
    TTwist2D twist;
    // At best |wanted|/1.0 + 1.0/2.0 s; a few periods more for rounding to periods.
    const int periods = static_cast<int>((std::abs(wanted) + 1.0) / kPeriod_s);
    for (int i = 0; i < periods; ++i) {
      const TTwist2D next = rotateInPlace(wanted - heading, twist, kLimits, kPeriod_s);
      ASSERT_LE(std::abs(next.omega), kLimits.maxYawRate_radps);
      ASSERT_LE(std::abs(next.omega - twist.omega), 0.2 + 1e-9);  // 2 rad/s² · 0.1 s
      twist = next;
      heading += twist.omega * kPeriod_s;
      // Rounding to whole periods may cost an eighth of 2 rad/s² · (0.1 s)².
      ASSERT_LT((heading - wanted) * std::copysign(1.0, wanted), 0.0025 + 1e-9);
    }
    EXPECT_NEAR(heading, wanted, 1e-3);
    EXPECT_TRUE(isStanding(twist)) << wanted;
  }
}

TEST(InPlaceRotation, BrakesADrivingRobotWithinItsLimits) {
  EXPECT_DOUBLE_EQ(rotateInPlace(1.0, {0.4, 0.0, 0.0}, kLimits, kPeriod_s).vx, 0.35);
}

TEST(InPlaceRotation, BrakesWhenItTurnsTheWrongWay) {
  EXPECT_DOUBLE_EQ(rotateInPlace(1.0, {0.0, 0.0, -0.5}, kLimits, kPeriod_s).omega, -0.3);
}

TEST(BearingTo, IsRelativeToTheHeadingAndWrapped) {
  EXPECT_NEAR(bearingTo({1.0, 1.0, 0.0}, {1.0, 3.0}), M_PI / 2, 1e-12);
  EXPECT_NEAR(bearingTo({0.0, 0.0, 3.0}, {-1.0, -0.1}), -M_PI + std::atan(0.1) - 3.0 + 2 * M_PI,
              1e-12);
}

TEST(IsStanding, AllowsForSensorNoiseOnly) {
  EXPECT_TRUE(isStanding({0.01, 0.0, -0.04}));
  EXPECT_FALSE(isStanding({-0.03, 0.0, 0.0}));
  EXPECT_FALSE(isStanding({0.0, 0.0, 0.06}));
}

}  // namespace
}  // namespace bslnav
