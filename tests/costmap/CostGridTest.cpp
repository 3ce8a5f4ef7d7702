#include <bslnav/costmap/CostGrid.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "CostmapTestTools.h"

namespace bslnav {
namespace {

TEST(CostGrid, OriginIsRoundedToWholeCells) {
  const CostGrid grid(4, 2, 0.5, 1.2, -0.3);  // 2.4 cells -> 2, -0.6 cells -> -1
  EXPECT_DOUBLE_EQ(grid.getXMin(), 1.0);
  EXPECT_DOUBLE_EQ(grid.getYMin(), -0.5);
  EXPECT_EQ(grid.bounds(), (CellWindow{0, 0, 4, 2}));
}

TEST(CostGrid, CellsLeftOfTheOriginHaveNegativeIndices) {
  const CostGrid grid(4, 2, 0.5, 1.0, -0.5);
  EXPECT_EQ(grid.cellX(0.9), -1);
  EXPECT_EQ(grid.cellY(-0.6), -1);
  EXPECT_EQ(grid.cellX(1.1), 0);
}

TEST(CostGrid, IsUnknownOutside) {
  const CostGrid grid(4, 2, 0.5, 1.0, -0.5, 7);
  EXPECT_EQ(grid.costAt(1.1, -0.4), 7);
  EXPECT_EQ(grid.costAt(0.9, -0.4), kUnknownCost);
  EXPECT_EQ(grid.costAt(1.1, 0.6), kUnknownCost);
}

RC_GTEST_PROP(CostGrid, ShiftKeepsWhatBothPositionsCoverAndFillsTheRest, ()) {
  const CostGrid before = test::anyBase(13, 9, 2);
  const int dx = *rc::gen::inRange(-16, 17), dy = *rc::gen::inRange(-12, 13);
  CostGrid after = before;
  after.shift(dx, dy, 77);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 13; ++x) {
      const bool covered = before.bounds().contains(x + dx, y + dy);
      RC_ASSERT(after.at(x, y) == (covered ? before.at(x + dx, y + dy) : Cost{77}));
    }
  RC_ASSERT(std::abs(after.getXMin() - 0.1 * dx) < 1e-9);
  RC_ASSERT(std::abs(after.getYMax() - 0.1 * (dy + 9)) < 1e-9);
}

}  // namespace
}  // namespace bslnav
