#include <bslnav/blindspot/DangerZones.h>
#include <bslnav/config/Config.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr double kDegree = M_PI / 180.0;

/** A number from −limit to limit, on a fine lattice. */
double anyWithin(double limit) {
  return limit * 1e-4 * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-10000, 10001));
}

BlindSpot anyBlindSpot() { return BlindSpot::at({anyWithin(8.0), anyWithin(8.0)}); }

TEST(DangerZone, LiesBesideTheBoundaryByShoulderWidthTimesTangent) {
  // P^b = (2, 1): tan θ^b = 1/2, P^o = (2, 1 + 0.5·0.5) = (2, 1.25)
  const DangerZone zone = dangerZone(BlindSpot::at({2.0, 1.0}), {}, 0.0, {});
  EXPECT_DOUBLE_EQ(zone.centre.x, 2.0);
  EXPECT_NEAR(zone.centre.y, 1.25, 1e-12);
}

TEST(DangerZone, IsGivenInTheMapFrame) {
  // The robot stands at (10, −4) and looks along +y: P^o = (2, 1.25) becomes (10 − 1.25, −4 + 2).
  const DangerZone zone = dangerZone(BlindSpot::at({2.0, 1.0}), {10.0, -4.0, M_PI / 2}, 0.0, {});
  EXPECT_NEAR(zone.centre.x, 8.75, 1e-12);
  EXPECT_NEAR(zone.centre.y, -2.0, 1e-12);
}

TEST(DangerZone, ReachesAsFarAsRobotAndPersonNeedToStop) {
  DangerZoneParameters parameters;
  EXPECT_DOUBLE_EQ(dangerZone(BlindSpot::at({2, 1}), {}, 0.0, parameters).radius_m,
                   1.0);  // 0.8 + 0.2
  EXPECT_DOUBLE_EQ(dangerZone(BlindSpot::at({2, 1}), {}, 0.5, parameters).radius_m,
                   1.25);  // + 0.25/(2·0.5)
  parameters.deceleration_mps2 = 0.25;
  EXPECT_DOUBLE_EQ(dangerZone(BlindSpot::at({2, 1}), {}, -0.5, parameters).radius_m,
                   1.5);  // + 0.25/(2·0.25)
}

TEST(DangerZone, TakesAmplitudeAndScalingFromTheParameters) {
  DangerZoneParameters parameters;
  parameters.amplitude = 200.0;
  parameters.scaling_per_m = 2.5;
  const DangerZone zone = dangerZone(BlindSpot::at({2, 1}), {}, 0.0, parameters);
  EXPECT_EQ(zone.amplitude, 200.0);
  EXPECT_EQ(zone.scaling_per_m, 2.5);
}

TEST(DangerZone, LimitsTheBearingBesideAndBehindTheRobot) {
  const double most_m = 0.5 * std::tan(80.0 * kDegree);  // 2.836 m
  EXPECT_NEAR(dangerZone(BlindSpot::at({0.0, 1.0}), {}, 0.0, {}).centre.y, 1.0 + most_m,
              1e-12);  // θ = 90°
  EXPECT_NEAR(dangerZone(BlindSpot::at({0.0, -1.0}), {}, 0.0, {}).centre.y, -1.0 - most_m,
              1e-12);  // −90°
  EXPECT_NEAR(dangerZone(BlindSpot::at({-1.0, 1.0}), {}, 0.0, {}).centre.y, 1.0 + most_m,
              1e-12);  // 135°
}

TEST(DangerZone, TakesTheLimitOfTheBearingFromTheParameters) {
  DangerZoneParameters parameters;
  parameters.maxBearing_rad = 45.0 * kDegree;  // tan = 1
  EXPECT_NEAR(dangerZone(BlindSpot::at({1.0, 3.0}), {}, 0.0, parameters).centre.y, 3.5, 1e-12);
}

RC_GTEST_PROP(DangerZoneLaw, MirroringTheWorldMirrorsTheZone, ()) {
  const BlindSpot left = anyBlindSpot();
  RC_PRE(left.position.y != 0.0);  // straight behind the robot is on neither side
  const DangerZone a = dangerZone(left, {}, 0.4, {});
  const DangerZone b = dangerZone(BlindSpot::at({left.position.x, -left.position.y}), {}, 0.4, {});
  RC_ASSERT((a.centre - TPoint2D(b.centre.x, -b.centre.y)).norm() < 1e-9);
}

RC_GTEST_PROP(DangerZoneLaw, RotatingAndMovingTheWorldMovesTheZoneAlong, ()) {
  const BlindSpot blindSpot = anyBlindSpot();
  const TPose2D mapFromRobot{anyWithin(20.0), anyWithin(20.0), anyWithin(M_PI)};
  const TPose2D otherFromMap{anyWithin(20.0), anyWithin(20.0), anyWithin(M_PI)};
  const DangerZone inMap = dangerZone(blindSpot, mapFromRobot, 0.4, {});
  const DangerZone inOther = dangerZone(blindSpot, otherFromMap + mapFromRobot, 0.4, {});
  RC_ASSERT((otherFromMap.composePoint(inMap.centre) - inOther.centre).norm() < 1e-9);
  RC_ASSERT(inMap.radius_m == inOther.radius_m);
}

RC_GTEST_PROP(DangerZoneLaw, TheRadiusGrowsWithTheSpeed, ()) {
  const double slow = std::abs(anyWithin(2.0)), faster = slow + 0.01;
  const BlindSpot blindSpot = anyBlindSpot();
  RC_ASSERT(dangerZone(blindSpot, {}, slow, {}).radius_m <
            dangerZone(blindSpot, {}, faster, {}).radius_m);
}

RC_GTEST_PROP(DangerZoneLaw, TheCentreIsNeverNearerToTheAxisThanTheBoundary, ()) {
  const BlindSpot blindSpot = anyBlindSpot();
  const DangerZone zone = dangerZone(blindSpot, {}, 0.4, {});
  RC_ASSERT(std::abs(zone.centre.y) >= std::abs(blindSpot.position.y));
  RC_ASSERT(std::abs(zone.centre.y) <=
            std::abs(blindSpot.position.y) + 0.5 * std::tan(80.0 * kDegree) + 1e-9);
}

TEST(DangerZoneParameters, LoadWithUnitsInTheirKeys) {
  DangerZoneParameters parameters;
  Config config;
  config.bind("danger", "danger zones", parameters);
  config.load({}, {"danger.shoulder_width_m=0.6", "danger.stride_m=0.7", "danger.offset_m=0.1",
                   "danger.amplitude=100", "danger.scaling_per_m=2", "danger.max_bearing_deg=60"});
  EXPECT_EQ(parameters.shoulderWidth_m, 0.6);
  EXPECT_EQ(parameters.stride_m, 0.7);
  EXPECT_EQ(parameters.offset_m, 0.1);
  EXPECT_EQ(parameters.amplitude, 100.0);
  EXPECT_EQ(parameters.scaling_per_m, 2.0);
  EXPECT_NEAR(parameters.maxBearing_rad, 60.0 * kDegree, 1e-12);
}

}  // namespace
}  // namespace bslnav
