#include <bslnav/config/Error.h>
#include <bslnav/simulation/StaticMap.h>
#include <gtest/gtest.h>

#include "TestWorld.h"

namespace bslnav {
namespace {

constexpr float kThreshold = 0.5f;

int occupiedCells(const mrpt::maps::COccupancyGridMap2D& map) {
  int n = 0;
  for (int y = 0; y < static_cast<int>(map.getSizeY()); ++y)
    for (int x = 0; x < static_cast<int>(map.getSizeX()); ++x)
      n += map.getCell(x, y) < kThreshold ? 1 : 0;
  return n;
}

TEST(StaticMap, BoxFillsExactlyItsCells) {
  WorldParameters world;
  world.boxes["b"] = test::box({1.0, 0.5, 0}, 1.0, 0.4);
  const auto map = staticMap(world, 0.1, 0.2, 1.0);
  EXPECT_EQ(occupiedCells(*map), 10 * 4);
  EXPECT_LT(map->getPos(0.55f, 0.35f), kThreshold);
  EXPECT_GT(map->getPos(0.45f, 0.35f), kThreshold);
}

TEST(StaticMap, CoversTheWorldAndTheMargin) {
  WorldParameters world;
  world.boxes["b"] = test::box({-5.0, -5.0, 0}, 1.0, 0.4);
  const auto map = staticMap(world, 0.1, 0.2, 2.0);
  EXPECT_NEAR(map->getXMin(), -7.5, 1e-5);
  EXPECT_NEAR(map->getXMax(), -2.5, 1e-5);
  EXPECT_NEAR(map->getYMin(), -7.2, 1e-5);
  EXPECT_NEAR(map->getYMax(), -2.8, 1e-5);
}

TEST(StaticMap, WallThinnerThanACellHasNoGaps) {
  WorldParameters world;
  world.walls["w"] = test::wall({0.03, 0.07}, {1.97, 0.93}, 0.01);
  const auto map = staticMap(world, 0.1, 0.2, 0.5);
  for (int i = 0; i <= 200; ++i) {
    const float f = static_cast<float>(i) / 200.0f;
    EXPECT_LT(map->getPos(0.03f + 1.94f * f, 0.07f + 0.86f * f), kThreshold) << i;
  }
}

TEST(StaticMap, CylinderFillsTheCellsItOverlaps) {
  WorldParameters world;
  world.cylinders["c"] = {0.05, 0.05, 0.06, 0.0, 1.0, true};
  // Centre of cell (0, 0): reaches 1 cm into the four neighbours, not the diagonal ones.
  EXPECT_EQ(occupiedCells(*staticMap(world, 0.1, 0.2, 1.0)), 5);
}

TEST(StaticMap, ShowsOnlyWhatIsMappedAndCrossesTheHeight) {
  WorldParameters world;
  world.boxes["unmapped"] = test::box({0, 0, 0}, 1.0, 1.0);
  world.boxes["unmapped"].mapped = false;
  world.boxes["low"] = test::box({2, 0, 0}, 1.0, 1.0, 0.0, 0.1);
  world.boxes["table"] = test::box({4, 0, 0}, 1.0, 1.0, 0.7, 0.75);
  EXPECT_EQ(occupiedCells(*staticMap(world, 0.1, 0.2, 1.0)), 0);
  EXPECT_EQ(occupiedCells(*staticMap(world, 0.1, 0.05, 1.0)), 100);
  EXPECT_EQ(occupiedCells(*staticMap(world, 0.1, 0.72, 1.0)), 100);
}

TEST(StaticMap, ResolutionOfZeroIsRefused) { EXPECT_THROW(staticMap({}, 0.0, 0.2, 1.0), Error); }

}  // namespace
}  // namespace bslnav
