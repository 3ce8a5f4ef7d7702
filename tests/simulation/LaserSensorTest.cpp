#include <bslnav/config/Error.h>
#include <bslnav/simulation/LaserSensor.h>
#include <gmock/gmock.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "TestWorld.h"

namespace bslnav {
namespace {

using mrpt::math::TPose2D;
using mrpt::obs::CObservation2DRangeScan;

const mrpt::Clock::time_point kStamp = mrpt::Clock::fromDouble(1e9);

/** A closed room of 4 m × 4 m around the origin: every beam hits. */
WorldParameters room() {
  WorldParameters world;
  world.walls["room"] = test::wall({-2, -2}, {2, -2});
  for (const mrpt::math::TPoint2D p : {mrpt::math::TPoint2D{2, 2}, {-2, 2}, {-2, -2}})
    world.walls["room"].points_m.push_back(p);
  return world;
}

TEST(LaserSensor, RangesToAWallFollowTheCosine) {
  WorldParameters world;
  world.walls["w"] = test::wall({3, -50}, {3, 50}, 0.2);
  LaserSensor laser("laser", test::exactLaser(), 1);
  const auto scan = laser.scan(RayScene(world, {}), {0.9, 0.0, 0.0}, kStamp);
  ASSERT_EQ(scan->getScanSize(), 683u);
  for (std::size_t i = 0; i < 683; ++i) {
    // The face is 3 - 0.1 - 0.9 = 2 m ahead: range 2/cos θ, seen up to 5.6 m.
    const double cosine = std::cos(static_cast<double>(scan->getScanAngle(i)));
    const bool seen = cosine > 2.0 / 5.6;
    ASSERT_EQ(scan->getScanRangeValidity(i), seen) << i;
    ASSERT_NEAR(scan->getScanRange(i), seen ? 2.0 / cosine : 5.6, 1e-4) << i;
  }
}

TEST(LaserSensor, MountingPositionAndDirectionCount) {
  WorldParameters world;
  world.walls["w"] = test::wall({-5, 3}, {5, 3}, 0.2);
  auto parameters = test::exactLaser();
  parameters.x_m = 0.4;
  parameters.yaw_rad = -M_PI / 2;
  LaserSensor laser("laser", parameters, 1);
  // Robot heading 180°, laser looking to its right: towards +y. From y = 1 the face at 2.9 is 1.9 m
  // away.
  const auto scan = laser.scan(RayScene(world, {}), {0.0, 1.0, M_PI}, kStamp);
  EXPECT_NEAR(scan->getScanRange(341), 1.9, 1e-4);
  EXPECT_DOUBLE_EQ(scan->sensorPose.x(), 0.4);
  EXPECT_DOUBLE_EQ(scan->sensorPose.yaw(), -M_PI / 2);
}

TEST(LaserSensor, ScanCarriesItsProperties) {
  LaserSensor laser("front", test::exactLaser(), 1);
  const auto scan = laser.scan(RayScene({}, {}), {}, kStamp);
  EXPECT_EQ(scan->sensorLabel, "front");
  EXPECT_EQ(scan->timestamp, kStamp);
  EXPECT_TRUE(scan->rightToLeft);
  EXPECT_FLOAT_EQ(scan->maxRange, 5.6f);
  EXPECT_FLOAT_EQ(scan->aperture, static_cast<float>(240.0 * test::kRadPerDeg));
}

TEST(LaserSensor, SurfacesNearerThanTheMinimumAreNotSeen) {
  auto parameters = test::exactLaser();
  parameters.minRange_m = 2.5;  // the room's faces are 1.95 m to 2.76 m away
  LaserSensor laser("laser", parameters, 1);
  const auto scan = laser.scan(RayScene(room(), {}), {}, kStamp);
  EXPECT_FALSE(scan->getScanRangeValidity(341));
  EXPECT_FLOAT_EQ(scan->getScanRange(341), 5.6f);
}

TEST(LaserSensor, NoiseHasTheMeanAndTheDeviationAskedFor) {
  auto noisy = test::exactLaser();
  noisy.noiseStd_m = 0.02;
  LaserSensor laser("laser", noisy, 7), exact("exact", test::exactLaser(), 7);
  const RayScene scene(room(), {});
  const auto truth = exact.scan(scene, {}, kStamp);
  double sum = 0.0, squares = 0.0;
  const double n = 20 * 683;
  for (int k = 0; k < 20; ++k) {
    const auto scan = laser.scan(scene, {}, kStamp);
    for (std::size_t i = 0; i < 683; ++i) {
      const double error = scan->getScanRange(i) - truth->getScanRange(i);
      sum += error;
      squares += error * error;
    }
  }
  EXPECT_NEAR(sum / n, 0.0, 5 * 0.02 / std::sqrt(n));  // 5 sigma of a mean
  EXPECT_NEAR(std::sqrt(squares / n), 0.02,
              5 * 0.02 / std::sqrt(2.0 * n));  // 5 sigma of a deviation
}

TEST(LaserSensor, BeamsDropOutAtTheRateAskedFor) {
  auto parameters = test::exactLaser();
  parameters.dropoutProbability = 0.1;
  LaserSensor laser("laser", parameters, 7);
  const RayScene scene(room(), {});
  int dropped = 0;
  for (int k = 0; k < 20; ++k) {
    const auto scan = laser.scan(scene, {}, kStamp);
    for (std::size_t i = 0; i < 683; ++i) dropped += scan->getScanRangeValidity(i) ? 0 : 1;
  }
  // Binomial: 13660 · 0.1 = 1366, deviation sqrt(13660 · 0.1 · 0.9) = 35; 5 of them.
  EXPECT_NEAR(dropped, 1366, 175);
}

TEST(LaserSensor, DropoutsDoNotChangeTheNoiseOfOtherBeams) {
  auto noisy = test::exactLaser();
  noisy.noiseStd_m = 0.02;
  auto dropping = noisy;
  dropping.dropoutProbability = 0.2;
  LaserSensor a("laser", noisy, 7), b("laser", dropping, 7);
  const RayScene scene(room(), {});
  const auto all = a.scan(scene, {}, kStamp), some = b.scan(scene, {}, kStamp);
  int compared = 0;
  for (std::size_t i = 0; i < 683; ++i)
    if (some->getScanRangeValidity(i)) {
      ASSERT_EQ(some->getScanRange(i), all->getScanRange(i)) << i;
      ++compared;
    }
  EXPECT_LT(compared, 683);
  EXPECT_GT(compared, 400);
}

TEST(LaserSensor, HeldScansAreNotOverwritten) {
  LaserSensor laser("laser", test::exactLaser(), 1);
  const RayScene scene(room(), {});
  const auto first = laser.scan(scene, {}, kStamp);
  const float before = first->getScanRange(341);
  const auto second = laser.scan(scene, {0.5, 0.0, 0.0}, kStamp);
  EXPECT_NE(first, second);
  EXPECT_EQ(first->getScanRange(341), before);
}

TEST(LaserSensor, ReleasedScansAreUsedAgainWithoutTheirOldContents) {
  LaserSensor laser("laser", test::exactLaser(), 1);
  const RayScene scene(room(), {}), empty({}, {});
  auto scan = laser.scan(scene, {}, kStamp);
  const void* address = scan.get();
  scan->buildAuxPointsMap<mrpt::maps::CSimplePointsMap>();
  scan.reset();
  scan = laser.scan(empty, {}, kStamp);
  EXPECT_EQ(scan.get(), address);
  EXPECT_EQ(scan->getAuxPointsMap<mrpt::maps::CSimplePointsMap>(), nullptr);
  EXPECT_FALSE(scan->getScanRangeValidity(341));
  EXPECT_FLOAT_EQ(scan->getScanRange(341), 5.6f);
}

TEST(LaserSensor, MaximumRangeBelowMinimumIsRefused) {
  LaserParameters parameters;
  parameters.minRange_m = 6.0;
  EXPECT_THAT([&] { LaserSensor("front", parameters, 1); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("[laser:front] max_range_m")));
}

// Solids with straight sides only: the prisms that stand for cylinders do not turn with the world.
RC_GTEST_PROP(LaserSensor, RotatingTheWorldAndTheRobotChangesNoRange, ()) {
  const auto number = [](int low, int high) { return *rc::gen::inRange(low, high) / 100.0; };
  const TPose2D turn(number(-500, 500), number(-500, 500), number(-314, 314));
  WorldParameters world, turned;
  for (int i = 0; i < 4; ++i) {
    const TPose2D pose(number(100, 400) * (i % 2 ? 1 : -1), number(100, 400) * (i < 2 ? 1 : -1),
                       number(-314, 314));
    const auto size = number(10, 100);
    world.boxes[std::to_string(i)] = test::box(pose, size, 0.3);
    turned.boxes[std::to_string(i)] = test::box(turn + pose, size, 0.3);
  }
  const TPose2D robot(0.0, 0.0, number(-314, 314));
  LaserSensor laser("laser", test::exactLaser(), 1);
  const auto before = laser.scan(RayScene(world, {}), robot, kStamp);
  const auto after = laser.scan(RayScene(turned, {}), turn + robot, kStamp);
  for (std::size_t i = 1; i + 1 < before->getScanSize(); ++i) {
    // At a silhouette rounding decides which side a beam passes: then it has a neighbour's range.
    const auto [low, high] = std::minmax(
        {before->getScanRange(i - 1), before->getScanRange(i), before->getScanRange(i + 1)});
    RC_ASSERT(after->getScanRange(i) > low - 0.001f);
    RC_ASSERT(after->getScanRange(i) < high + 0.001f);
  }
}

}  // namespace
}  // namespace bslnav
