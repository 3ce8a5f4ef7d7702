#include <bslnav/config/Error.h>
#include <bslnav/costmap/StaticLayer.h>
#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <rapidcheck/gtest.h>

#include "CostmapTestTools.h"

namespace bslnav {
namespace {

using mrpt::maps::COccupancyGridMap2D;

/** 4 × 3 cells of 0.1 m from (−0.2, 0.1), all free (probability of being free 0.9). */
COccupancyGridMap2D smallMap() {
  COccupancyGridMap2D map(-0.2f, 0.2f, 0.1f, 0.4f, 0.1f);
  map.fill(0.9f);
  return map;
}

TEST(StaticLayer, ThresholdsSeparateFreeUnknownAndOccupied) {
  COccupancyGridMap2D map = smallMap();
  map.setCell(0, 0, 0.3f);  // occupied with 0.7
  map.setCell(1, 0, 0.5f);
  const StaticLayer layer(map, 0.1, {});
  EXPECT_EQ(layer.grid().at(0, 0), kLethalCost);
  EXPECT_EQ(layer.grid().at(1, 0), kUnknownCost);
  EXPECT_EQ(layer.grid().at(2, 0), kFreeCost);
}

TEST(StaticLayer, KeepsCellsOfTheSameResolutionWhereTheyAre) {
  COccupancyGridMap2D map = smallMap();
  map.setCell(3, 2, 0.1f);
  const StaticLayer layer(map, 0.1, {});
  EXPECT_EQ(layer.grid().bounds(), (CellWindow{0, 0, 4, 3}));
  EXPECT_EQ(layer.grid().costAt(0.15, 0.35), kLethalCost);
  EXPECT_EQ(std::count(layer.grid().begin(), layer.grid().end(), kLethalCost), 1);
}

TEST(StaticLayer, FinerCellsTakeTheMapCellTheyLieIn) {
  COccupancyGridMap2D map = smallMap();
  map.setCell(1, 1, 0.1f);
  const StaticLayer layer(map, 0.05, {});
  EXPECT_EQ(layer.grid().bounds(), (CellWindow{0, 0, 8, 6}));
  EXPECT_EQ(std::count(layer.grid().begin(), layer.grid().end(), kLethalCost), 4);  // (0.1 / 0.05)²
  EXPECT_EQ(layer.grid().costAt(-0.08, 0.22), kLethalCost);
}

TEST(StaticLayer, CoarserCellsTakeTheWorstTheyOverlap) {
  COccupancyGridMap2D map = smallMap();
  map.setCell(0, 1, 0.5f);
  map.setCell(1, 1, 0.1f);
  map.setCell(2, 2, 0.5f);
  // Cells of 0.2 m: columns −0.2..0..0.2, rows 0..0.2..0.4; row 0..0.2 overlaps the map's first row
  // and 0.1 m off the map.
  const StaticLayer layer(map, 0.2, {});
  EXPECT_EQ(layer.grid().bounds(), (CellWindow{0, 0, 2, 2}));
  EXPECT_EQ(layer.grid().at(0, 0), kUnknownCost);  // partly off the map
  EXPECT_EQ(layer.grid().at(0, 1), kLethalCost);   // occupied beats unknown
  EXPECT_EQ(layer.grid().at(1, 1), kUnknownCost);  // unknown beats free
}

RC_GTEST_PROP(StaticLayer, CopyIsTheMapWhereThereIsOneAndUnknownElsewhere, ()) {
  COccupancyGridMap2D map = smallMap();
  map.setCell(*rc::gen::inRange(0, 4), *rc::gen::inRange(0, 3), 0.1f);
  const StaticLayer layer(map, 0.1, {});
  CostGrid copy(5, 4, 0.1, 0.1 * *rc::gen::inRange(-9, 6), 0.1 * *rc::gen::inRange(-6, 8), 77);
  const CellWindow window =
      CellWindow{0, 0, 2, 3}.shifted(*rc::gen::inRange(-2, 5), *rc::gen::inRange(-3, 4));
  layer.copyTo(copy, window);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x) {
      const Cost fromMap = layer.grid().costAt(copy.idx2x(x), copy.idx2y(y));
      RC_ASSERT(copy.at(x, y) == (window.contains(x, y) ? fromMap : Cost{77}));
    }
}

TEST(StaticLayer, RefusesThresholdsInTheWrongOrder) {
  StaticParameters parameters;
  parameters.freeThreshold = 0.7;
  EXPECT_THROW(parameters.check(), Error);
}

}  // namespace
}  // namespace bslnav
