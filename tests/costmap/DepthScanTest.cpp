#include <bslnav/costmap/DepthScan.h>
#include <bslnav/costmap/LayeredCostmap.h>
#include <gtest/gtest.h>

#include "../support/DepthScene.h"
#include "../support/HeapUse.h"

namespace bslnav {
namespace {

using test::cameraAt;
using test::DepthScene;
using Beam = PlanarScan::Beam;

constexpr double kStep_rad = 1.05 / 80.0;  // a pixel in the middle is 1/80 wide

PlanarScan scanOf(const DepthScene& scene, const mrpt::poses::CPose3D& camera) {
  DepthFrame frame;
  frame.assign(scene.picture(camera, 160, 120));
  return DepthScan().make(frame);
}

/** The beam that points straight ahead. */
std::size_t ahead(const PlanarScan& scan) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < scan.beam.size(); ++i)
    if (scan.cosine[i] > scan.cosine[best]) best = i;
  return best;
}

TEST(DepthScan, FindsTheNearestObstacleOfAnyHeight) {
  // A table top at 2 m before a wall at 3 m.
  const DepthScene scene{{{2.0, 2.6, -0.5, 0.5, 0.70, 0.75}, {3.0, 3.2, -9.0, 9.0, 0.0, 2.0}}, 0.0};
  const PlanarScan scan = scanOf(scene, cameraAt(0.6));
  const std::size_t i = ahead(scan);
  EXPECT_EQ(scan.beam[i], Beam::Hit);
  EXPECT_NEAR(scan.range_m[i], 2.0, 0.02);
  EXPECT_NEAR(scan.top_m[i], 0.75, 0.05);  // two pixels of 2/80 m
  const auto aside = i + static_cast<std::size_t>(std::lround(0.5 / kStep_rad));  // y = 0.55 x
  EXPECT_NEAR(scan.range_m[aside], 3.0 / std::cos(0.5), 0.05);
}

TEST(DepthScan, LeavesOutFloorAndWhatIsAboveTheRobot) {
  const DepthScene scene{{{1.5, 3.0, -9.0, 9.0, 0.0, 0.05}, {2.0, 2.5, -9.0, 9.0, 1.2, 2.0}}, 0.0};
  const PlanarScan scan = scanOf(scene, cameraAt(0.6, 0.2));
  EXPECT_EQ(scan.hits(), 0);
  EXPECT_EQ(scan.beam[ahead(scan)], Beam::NoReturn);
  EXPECT_GT(scan.range_m[ahead(scan)], 3.0);  // as far as the floor is seen, at most 6 m
  EXPECT_LE(scan.range_m[ahead(scan)], 6.2);
}

TEST(DepthScan, KnowsFromWhereOnItSeesTheFloor) {
  // The lowest row looks 59.5/80 down per metre: the floor is met 0.6·80/59.5 = 0.807 m ahead.
  const PlanarScan scan = scanOf({}, cameraAt(0.6));
  EXPECT_NEAR(scan.start_m[ahead(scan)], 0.6 * 80.0 / 59.5, 1e-3);
  EXPECT_DOUBLE_EQ(scan.sensorHeight_m, static_cast<double>(0.6f));
}

TEST(DepthScan, MakesNoObstacleOfASinglePixel) {
  auto image = DepthScene{{{3.0, 3.2, -9.0, 9.0, 0.0, 2.0}}, 0.0}.picture(cameraAt(0.6), 160, 120);
  image.rangeImage(60, 80) = 1000;
  DepthFrame frame;
  frame.assign(image);
  DepthScan scan;
  for (const float range : scan.make(frame).range_m) EXPECT_GT(range, 1.5f);
  image.rangeImage(61, 80) = 1000;  // two above each other are one
  frame.assign(image);
  const auto& ranges = scan.make(frame).range_m;
  EXPECT_LT(*std::min_element(ranges.begin(), ranges.end()), 1.1f);
}

TEST(DepthScan, AllocatesNothingTheSecondTime) {
  DepthFrame frame;
  frame.assign(DepthScene{}.picture(cameraAt(0.6)));
  DepthScan scan;
  scan.make(frame);
  const long before = test::heapUse().allocations;
  scan.make(frame);
  EXPECT_EQ(test::heapUse().allocations, before);
}

/** A cost map around a robot at the origin, without a map. */
class DepthObstacles : public testing::Test {
 protected:
  void see(const DepthScene& scene, const mrpt::math::TPose2D& pose = {}) {
    costmap_.update(pose, lasers_, {}, {scanOf(scene, cameraAt(0.6))});
  }
  /** A laser that sees nothing in any direction, as below a table top. */
  void addClearLaser() {
    mrpt::obs::CObservation2DRangeScan laser;
    laser.aperture = static_cast<float>(M_PI);
    laser.maxRange = 5.6f;
    laser.resizeScanAndAssign(361, 5.6f, false);
    lasers_.resize(1);
    lasers_[0].assign(laser);
  }
  /** A laser that sees a wall across the way. */
  void laserMeets(double x_m) {
    mrpt::obs::CObservation2DRangeScan laser;
    laser.aperture = static_cast<float>(M_PI / 2.0);
    laser.maxRange = 5.6f;
    laser.resizeScan(181);
    for (std::size_t i = 0; i < 181; ++i) {
      const double angle = M_PI / 2.0 * (static_cast<double>(i) / 180.0 - 0.5);
      laser.setScanRange(i, static_cast<float>(x_m / std::cos(angle)));
      laser.setScanRangeValidity(i, true);
    }
    lasers_.resize(1);
    lasers_[0].assign(laser);
  }
  Cost at(double x, double y) const { return costmap_.costs().costAt(x, y); }
  bool isMarkedNear(double x, double y) const {
    for (double dx = -0.05; dx < 0.06; dx += 0.05)
      if (at(x + dx, y) == kLethalCost) return true;
    return false;
  }

  LayeredCostmap costmap_{CostmapParameters{}, Footprint{}, nullptr, Extent::Rolling};
  std::vector<PlanarScan> lasers_;
};

const DepthScene kTable{{{2.0, 2.6, -0.5, 0.5, 0.70, 0.75}}, 0.0};

TEST_F(DepthObstacles, ATableTopStaysThoughTheLaserSeesBelowIt) {
  addClearLaser();
  for (int i = 0; i < 3; ++i) see(kTable);
  EXPECT_TRUE(isMarkedNear(2.0, 0.0));
  costmap_.update({}, lasers_, {});  // a cycle with the laser alone
  EXPECT_TRUE(isMarkedNear(2.0, 0.0));
}

TEST_F(DepthObstacles, AreClearedWhenTheyAreGone) {
  see(kTable);
  see({});
  EXPECT_FALSE(isMarkedNear(2.0, 0.0));
}

TEST_F(DepthObstacles, ALowThingBelowTheViewStays) {
  const DepthScene box{{{1.2, 1.5, -0.3, 0.3, 0.0, 0.2}}, 0.0};
  see(box);
  ASSERT_TRUE(isMarkedNear(1.2, 0.0));
  // 0.7 m on the box is 0.5 m ahead, where the camera sees nothing below 0.6·(1 − 0.5/0.807) = 0.23
  // m.
  see({}, {0.7, 0.0, 0.0});
  EXPECT_TRUE(isMarkedNear(1.2, 0.0));
}

/** So whoever was seen in part only, because of standing so near, leaves nothing behind. */
TEST_F(DepthObstacles, AThingBelowTheViewStaysAsLongAsTheLaserMeetsIt) {
  const DepthScene box{{{1.2, 1.5, -0.3, 0.3, 0.0, 0.2}}, 0.0};
  laserMeets(1.2);
  see(box);
  laserMeets(0.5);
  see({}, {0.7, 0.0, 0.0});
  EXPECT_TRUE(isMarkedNear(1.2, 0.0));
  addClearLaser();
  see({}, {0.7, 0.0, 0.0});
  EXPECT_FALSE(isMarkedNear(1.2, 0.0));
}

TEST_F(DepthObstacles, ATallThingThatLeftIsClearedEvenBelowTheViewOfTheFloor) {
  const DepthScene person{{{1.2, 1.5, -0.3, 0.3, 0.0, 0.95}}, 0.0};
  see(person);
  ASSERT_TRUE(isMarkedNear(1.2, 0.0));
  see({}, {0.7, 0.0, 0.0});
  EXPECT_FALSE(isMarkedNear(1.2, 0.0));
}

TEST(ObstacleLayer, ClearsATallThingWhereTheFloorIsSeenOnlyBeyondTheRaytraceRange) {
  ObstacleParameters parameters;  // raytrace_range_m = 6
  ObstacleLayer layer(parameters, Footprint{}, CostGrid(200, 100, 0.05, 0.0, -2.5));
  PlanarScan scan;
  const auto seeAt = [&](float range_m) {
    scan.reset({}, 10.0, 3);
    for (std::size_t i = 0; i < 3; ++i) {
      const double angle = 0.01 * (static_cast<double>(i) - 1.0);
      scan.cosine[i] = static_cast<float>(std::cos(angle));
      scan.sine[i] = static_cast<float>(std::sin(angle));
      scan.setBeam(i, Beam::Hit, range_m);
    }
    scan.start_m.assign(3, 7.0f);
    scan.top_m.assign(3, 1.0f);
    scan.sensorHeight_m = 1.2;
    layer.update({0.025, 0.025, 0.0}, {scan});
  };
  seeAt(2.0f);
  ASSERT_EQ(layer.grid().costAt(2.026, 0.025), kLethalCost);
  seeAt(4.0f);  // what is above 1.2 (1 - 2/7) = 0.86 m at 2 m would still be seen
  EXPECT_EQ(layer.grid().costAt(2.026, 0.025), kFreeCost);
}

TEST_F(DepthObstacles, AreInPlaceAfterAMapThatRolledBeforeTheFirstImage) {
  costmap_.update({3.0, 1.0, 0.0}, {}, {});
  see(kTable, {3.0, 1.0, 0.0});
  EXPECT_TRUE(isMarkedNear(5.0, 1.0));
}

}  // namespace
}  // namespace bslnav
