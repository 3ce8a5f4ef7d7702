#include <bslnav/config/ConfigSection.h>
#include <bslnav/config/Error.h>
#include <bslnav/costmap/LayeredCostmap.h>
#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "CostmapTestTools.h"

namespace bslnav {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPose2D;

/** 6 m × 4 m at 0.125 m: a resolution that floating point holds exactly. */
CostmapParameters smallParameters() {
  CostmapParameters parameters;
  parameters.resolution_m = 0.125;
  parameters.width_m = 6.0;
  parameters.height_m = 4.0;
  parameters.obstacles.obstacleRange_m = 2.5;
  parameters.obstacles.raytraceRange_m = 3.0;
  return parameters;
}

/** 8 m × 8 m around (0, 0): free, unknown on the right, with a wall at the top. */
std::shared_ptr<const COccupancyGridMap2D> smallMap() {
  auto map = std::make_shared<COccupancyGridMap2D>(-4.0f, 4.0f, -4.0f, 4.0f, 0.125f);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) map->setCell(x, y, y >= 62 ? 0.05f : x >= 50 ? 0.5f : 0.95f);
  return map;
}

/** The same layers, every cycle over every cell. */
class FullRecomputation {
 public:
  FullRecomputation(const CostmapParameters& parameters,
                    std::shared_ptr<const COccupancyGridMap2D> map, const CostGrid& shape)
      : parameters_(parameters),
        map_(std::move(map)),
        obstacles_(parameters.obstacles, {}, shape) {}

  CostGrid update(const CostGrid& shape, const TPose2D& pose, const std::vector<PlanarScan>& scans,
                  const std::vector<DangerZone>& zones) {
    const auto cells = [&](double now_m, double before_m) {
      return static_cast<int>(std::lround((now_m - before_m) / parameters_.resolution_m));
    };
    obstacles_.shift(cells(shape.getXMin(), obstacles_.grid().getXMin()),
                     cells(shape.getYMin(), obstacles_.grid().getYMin()));
    obstacles_.update(pose, scans);
    CostGrid merged = shape;
    merged.fill(kFreeCost);
    if (map_)
      StaticLayer(*map_, parameters_.resolution_m, parameters_.map).copyTo(merged, merged.bounds());
    for (int y = 0; y < merged.height(); ++y)
      for (int x = 0; x < merged.width(); ++x) {
        const Cost seen = obstacles_.grid().at(x, y);
        if (seen == kLethalCost || (seen == kFreeCost && merged.at(x, y) == kUnknownCost))
          merged.at(x, y) = seen;
      }
    CostGrid result = merged;
    InflationLayer(parameters_.inflation, Footprint().inscribedRadius_m(), parameters_.resolution_m)
        .apply(merged, merged.bounds(), result);
    addDangerZones(zones, result);
    return result;
  }

 private:
  CostmapParameters parameters_;
  std::shared_ptr<const COccupancyGridMap2D> map_;
  ObstacleLayer obstacles_;
};

std::vector<DangerZone> anyZones(const TPose2D& around) {
  std::vector<DangerZone> zones(static_cast<std::size_t>(*rc::gen::inRange(0, 3)));
  for (auto& zone : zones) {
    zone.centre = {around.x + test::anyNumber(-4.0, 4.0), around.y + test::anyNumber(-3.0, 3.0)};
    zone.radius_m = test::anyNumber(0.2, 2.0);
  }
  return zones;
}

RC_GTEST_PROP(LayeredCostmap, WindowedUpdateEqualsFullRecomputation, ()) {
  const auto parameters = smallParameters();
  const auto map = *rc::gen::element(0, 1) ? smallMap() : nullptr;
  const Extent extent = map && *rc::gen::element(0, 1) ? Extent::WholeMap : Extent::Rolling;
  LayeredCostmap costmap(parameters, {}, map, extent);
  FullRecomputation full(parameters, map, costmap.costs());
  TPose2D pose = test::anyPose(3.0);
  for (int cycle = 0; cycle < 12; ++cycle) {
    if (*rc::gen::element(0, 1))
      pose = pose + TPose2D(test::anyNumber(-0.3, 0.6), 0.0, test::anyNumber(-0.5, 0.5));
    std::vector<PlanarScan> scans;
    for (int i = *rc::gen::inRange(0, 3); i > 0; --i) scans.push_back(test::anyScan(20, 4.0));
    const auto zones = anyZones(pose);
    costmap.update(pose, scans, zones);
    RC_ASSERT(test::same(costmap.costs(), full.update(costmap.costs(), pose, scans, zones)));
    RC_ASSERT(
        test::same(costmap.costsWithoutBlindSpots(), full.update(costmap.costs(), pose, {}, {})));
  }
}

RC_GTEST_PROP(LayeredCostmap, TranslatingTheWorldByWholeCellsTranslatesTheCosts, ()) {
  const int dx = *rc::gen::inRange(-400, 400), dy = *rc::gen::inRange(-400, 400);
  LayeredCostmap here(smallParameters(), {}, nullptr, Extent::Rolling),
      there(smallParameters(), {}, nullptr, Extent::Rolling);
  for (int cycle = 0; cycle < 4; ++cycle) {
    const TPose2D pose = test::anyPose(1.0);
    const std::vector<PlanarScan> scans{test::anyScan(40, 4.0)};
    const auto zones = anyZones(pose);
    auto movedZones = zones;
    for (auto& zone : movedZones)
      zone.centre = {zone.centre.x + 0.125 * dx, zone.centre.y + 0.125 * dy};
    here.update(pose, scans, zones);
    there.update({pose.x + 0.125 * dx, pose.y + 0.125 * dy, pose.phi}, scans, movedZones);
    RC_ASSERT(here.costs().getXMin() + 0.125 * dx == there.costs().getXMin());
    RC_ASSERT(here.costsWithoutBlindSpots().data() == there.costsWithoutBlindSpots().data());
  }
}

TEST(LayeredCostmap, RollingGridKeepsTheRobotInTheMiddle) {
  LayeredCostmap costmap(smallParameters(), {}, nullptr, Extent::Rolling);
  costmap.update({100.06, -50.06, 1.0}, {}, {});
  EXPECT_EQ(costmap.costs().bounds(), (CellWindow{0, 0, 48, 32}));
  EXPECT_EQ(costmap.costs().cellX(100.06), 24);
  EXPECT_EQ(costmap.costs().cellY(-50.06), 16);
}

TEST(LayeredCostmap, MarkKeepsItsPlaceWhileTheRobotDrives) {
  LayeredCostmap costmap(smallParameters(), {}, nullptr, Extent::Rolling);
  costmap.update({0.06, 0.06, 0.0}, {test::oneBeam(2.0)}, {});
  costmap.update({0.56, 0.31, 0.0}, {}, {});
  EXPECT_EQ(costmap.costs().costAt(2.06, 0.06), kLethalCost);
}

TEST(LayeredCostmap, WithoutAMapCellsAreFreeUntilMarked) {
  LayeredCostmap costmap(smallParameters(), {}, nullptr, Extent::Rolling);
  costmap.update({0.0, 0.0, 0.0}, {}, {});
  EXPECT_EQ(std::count(costmap.costs().begin(), costmap.costs().end(), kFreeCost), 48 * 32);
}

TEST(LayeredCostmap, CellsOffTheMapAreUnknown) {
  LayeredCostmap costmap(smallParameters(), {}, smallMap(), Extent::Rolling);
  costmap.update({-3.5, 0.0, 0.0}, {}, {});
  EXPECT_EQ(costmap.costs().costAt(-4.1, 0.0), kUnknownCost);
  EXPECT_EQ(costmap.costs().costAt(-3.9, 0.0), kFreeCost);
}

TEST(LayeredCostmap, BeamMakesUnknownCellsFreeButNotWalls) {
  LayeredCostmap costmap(smallParameters(), {}, smallMap(), Extent::WholeMap);
  costmap.update({1.06, 3.81, 0.0}, {test::oneBeam(-1.0)},
                 {});  // along the wall, rows 62 and 63 from y = 3.75
  EXPECT_EQ(costmap.costs().costAt(2.06, 3.81), kLethalCost);
  EXPECT_EQ(costmap.costs().costAt(3.06, 0.06), kUnknownCost);
  costmap.update({1.06, 0.06, 0.0}, {test::oneBeam(-1.0)}, {});
  EXPECT_EQ(costmap.costs().costAt(3.06, 0.06), kFreeCost);
}

TEST(LayeredCostmap, DangerZonesOfTheLastCycleAreGone) {
  LayeredCostmap costmap(smallParameters(), {}, nullptr, Extent::Rolling);
  DangerZone zone;
  zone.centre = {1.0, 0.0};
  zone.radius_m = 1.0;
  costmap.update({0.0, 0.0, 0.0}, {}, {zone});
  EXPECT_GT(costmap.costs().costAt(1.06, 0.06), 200);
  EXPECT_EQ(costmap.costsWithoutBlindSpots().costAt(1.06, 0.06), kFreeCost);
  costmap.update({0.0, 0.0, 0.0}, {}, {});
  EXPECT_EQ(costmap.costs().costAt(1.06, 0.06), kFreeCost);
}

TEST(LayeredCostmap, WholeMapNeedsAMap) {
  EXPECT_THROW(LayeredCostmap(smallParameters(), {}, nullptr, Extent::WholeMap), Error);
}

TEST(LayeredCostmap, RefusesMoreCellsThanItCanHold) {
  auto parameters = smallParameters();
  parameters.resolution_m = 0.005;
  parameters.width_m = 100.0;  // 20000 cells
  EXPECT_THROW(LayeredCostmap(parameters, {}, nullptr, Extent::Rolling), Error);
}

TEST(CostmapParameters, DescribeEveryKeyOnce) {
  CostmapParameters parameters;
  ConfigSection section("costmap", "");
  parameters.describe(section);
  std::set<std::string> keys;
  for (const auto& field : section.fields())
    EXPECT_TRUE(keys.insert(field.key).second) << field.key;
  EXPECT_EQ(keys.size(), 11u);
}

}  // namespace
}  // namespace bslnav
