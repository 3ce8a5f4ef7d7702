#include <bslnav/costmap/ObstacleLayer.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "CostmapTestTools.h"

namespace bslnav {
namespace {

using mrpt::math::TPose2D;
using test::oneBeam;

constexpr double kCell_m = 0.1;

/** Marking and clearing only. */
ObstacleParameters withoutFootprint() {
  ObstacleParameters parameters;
  parameters.obstacleRange_m = 3.0;
  parameters.raytraceRange_m = 4.0;
  parameters.clearFootprint = false;
  return parameters;
}

/** 10 m × 1 m from (0, 0); robots in these tests look along its middle row 5. */
ObstacleLayer corridor(const ObstacleParameters& parameters = withoutFootprint()) {
  return {parameters, {}, CostGrid(100, 10, kCell_m, 0.0, 0.0)};
}

const TPose2D kAtStart(1.05, 0.55, 0.0);  // middle of cell (10, 5)

TEST(ObstacleLayer, BeamClearsUpToItsEndAndMarksThere) {
  auto layer = corridor();
  layer.update(kAtStart, {oneBeam(2.0)});
  EXPECT_EQ(layer.grid().at(9, 5), kUnknownCost);
  for (int x = 10; x < 30; ++x) EXPECT_EQ(layer.grid().at(x, 5), kFreeCost) << x;
  EXPECT_EQ(layer.grid().at(30, 5), kLethalCost);  // 1.05 + 2.0
  EXPECT_EQ(layer.grid().at(31, 5), kUnknownCost);
}

TEST(ObstacleLayer, MarkStaysUntilABeamPassesThroughIt) {
  auto layer = corridor();
  layer.update(kAtStart, {oneBeam(2.0)});
  layer.update(kAtStart, {oneBeam(1.0)});  // ends before it
  EXPECT_EQ(layer.grid().at(30, 5), kLethalCost);
  layer.update(kAtStart, {oneBeam(2.5)});
  EXPECT_EQ(layer.grid().at(30, 5), kFreeCost);
}

TEST(ObstacleLayer, ReturnBeyondObstacleRangeClearsButMakesNoMark) {
  auto layer = corridor();
  layer.update(kAtStart, {oneBeam(3.5)});
  EXPECT_EQ(layer.grid().at(44, 5), kFreeCost);
  EXPECT_EQ(layer.grid().at(45, 5), kUnknownCost);
}

TEST(ObstacleLayer, ReturnBeyondRaytraceRangeClearsUpToThatRange) {
  auto layer = corridor();
  layer.update(kAtStart, {oneBeam(7.0)});
  EXPECT_EQ(layer.grid().at(49, 5), kFreeCost);  // 1.05 + 4.0 lies in cell 50
  EXPECT_EQ(layer.grid().at(50, 5), kUnknownCost);
  EXPECT_EQ(layer.grid().at(80, 5), kUnknownCost);
}

TEST(ObstacleLayer, BeamWithoutReturnClearsUpToRaytraceRange) {
  auto layer = corridor();
  layer.update(kAtStart, {oneBeam(2.0)});
  layer.update(kAtStart, {oneBeam(-1.0)});
  EXPECT_EQ(layer.grid().at(30, 5), kFreeCost);
  EXPECT_EQ(layer.grid().at(49, 5), kFreeCost);
}

TEST(ObstacleLayer, BeamWithoutReturnDoesNothingIfSoConfigured) {
  auto parameters = withoutFootprint();
  parameters.clearNoReturn = false;
  auto layer = corridor(parameters);
  layer.update(kAtStart, {oneBeam(2.0)});
  layer.update(kAtStart, {oneBeam(-1.0)});
  EXPECT_EQ(layer.grid().at(30, 5), kLethalCost);
}

TEST(ObstacleLayer, DroppedBeamDoesNothing) {
  auto layer = corridor();
  layer.update(kAtStart, {oneBeam(std::nan("")), oneBeam(0.0)});
  EXPECT_EQ(std::count(layer.grid().begin(), layer.grid().end(), kUnknownCost), 1000);
}

TEST(ObstacleLayer, MarksOfACycleAreMadeAfterAllClearing) {
  auto layer = corridor();
  layer.update(kAtStart,
               {oneBeam(2.0), oneBeam(2.5)});  // the second passes through the end of the first
  EXPECT_EQ(layer.grid().at(30, 5), kLethalCost);
  EXPECT_EQ(layer.grid().at(35, 5), kLethalCost);
}

TEST(ObstacleLayer, SensorOutsideTheGridClearsAndMarksInside) {
  auto layer = corridor();
  layer.update({-1.05, 0.55, 0.0}, {oneBeam(2.0)});
  EXPECT_EQ(layer.grid().at(0, 5), kFreeCost);
  EXPECT_EQ(layer.grid().at(8, 5), kFreeCost);
  EXPECT_EQ(layer.grid().at(9, 5), kLethalCost);
}

TEST(ObstacleLayer, BeamThatLeavesTheGridClearsUpToItsEdge) {
  auto layer = corridor();
  layer.update({9.05, 0.55, 0.0}, {oneBeam(2.5)});
  EXPECT_EQ(layer.grid().at(99, 5), kFreeCost);
  EXPECT_EQ(std::count(layer.grid().begin(), layer.grid().end(), kLethalCost), 0);
}

TEST(ObstacleLayer, RobotsFootprintIsCleared) {
  auto parameters = withoutFootprint();
  parameters.clearFootprint = true;
  Footprint footprint;
  footprint.polygon = {{0.6, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.6, -0.2}};
  ObstacleLayer layer(parameters, footprint, CostGrid(100, 10, kCell_m, 0.0, 0.0));
  layer.update(kAtStart, {oneBeam(0.5)});  // ends under the robot's front
  EXPECT_EQ(layer.grid().at(15, 5), kFreeCost);
  layer.update(kAtStart, {oneBeam(0.8)});
  EXPECT_EQ(layer.grid().at(18, 5), kLethalCost);
  // Cell centres within x −0.2..0.6 and y −0.2..0.2 of the centre of cell (10, 5): 8 or 9 columns,
  // 3 to 5 rows.
  EXPECT_EQ(layer.grid().at(9, 6), kFreeCost);
  EXPECT_EQ(layer.grid().at(10, 8), kUnknownCost);
}

/** What the class's documentation says a scan does, cell by cell, without regard to where the grid
 * ends or to speed. Cells that a beam passes within `slack` cells of their border are recorded in
 * both sets' difference. */
struct Oracle {
  std::vector<std::pair<int, int>> cleared, perhaps, marked;

  void addBeam(double x0, double y0, double x1, double y1) {
    const bool alongX = std::abs(x1 - x0) >= std::abs(y1 - y0);
    if (!alongX) std::swap(x0, y0), std::swap(x1, y1);
    const int first = static_cast<int>(std::floor(x0)), last = static_cast<int>(std::floor(x1));
    for (int column = first; column != last; column += last > first ? 1 : -1) {
      const double row = y0 + (column + 0.5 - x0) * (y1 - y0) / (x1 - x0);
      const int low = static_cast<int>(std::floor(row - 1e-6)),
                high = static_cast<int>(std::floor(row + 1e-6));
      for (int r = low; r <= high; ++r) {
        const std::pair<int, int> cell =
            alongX ? std::make_pair(column, r) : std::make_pair(r, column);
        (low == high ? cleared : perhaps).push_back(cell);
      }
    }
  }
};

RC_GTEST_PROP(ObstacleLayer, EqualsTheDocumentedTraversal, ()) {
  const auto parameters = withoutFootprint();
  CostGrid before = test::anyBase(40, 30, 2);
  ObstacleLayer layer(parameters, {}, before);
  const TPose2D pose(test::anyNumber(-2.0, 6.0), test::anyNumber(-2.0, 5.0),
                     test::anyNumber(-3.0, 3.0));
  const PlanarScan scan = test::anyScan(60, 6.0);
  const CellWindow visited = layer.update(pose, {scan});

  Oracle oracle;
  const auto& mount = scan.robotFromSensor();
  const double c = std::cos(pose.phi), s = std::sin(pose.phi);
  const double x = (pose.x + c * mount.x - s * mount.y) / kCell_m,
               y = (pose.y + s * mount.x + c * mount.y) / kCell_m;
  for (std::size_t i = 0; i < scan.beam.size(); ++i) {
    if (scan.beam[i] == PlanarScan::Beam::Dropped) continue;
    const double dx = (c * scan.cosine[i] - s * scan.sine[i]) / kCell_m,
                 dy = (s * scan.cosine[i] + c * scan.sine[i]) / kCell_m;
    const double range = scan.range_m[i], clears = std::min(range, parameters.raytraceRange_m);
    oracle.addBeam(x, y, x + clears * dx, y + clears * dy);
    if (scan.beam[i] == PlanarScan::Beam::Hit && range <= parameters.obstacleRange_m)
      oracle.marked.emplace_back(static_cast<int>(std::floor(x + range * dx)),
                                 static_cast<int>(std::floor(y + range * dy)));
  }
  CostGrid expected(40, 30, kCell_m, 0.0, 0.0, kUnknownCost);
  const auto set = [&](const auto& cells, Cost cost) {
    for (const auto& cell : cells)
      if (expected.bounds().contains(cell.first, cell.second))
        expected.at(cell.first, cell.second) = cost;
  };
  set(oracle.perhaps, 77);
  set(oracle.cleared, kFreeCost);
  set(oracle.marked, kLethalCost);
  for (int v = 0; v < 30; ++v)
    for (int u = 0; u < 40; ++u) {
      RC_ASSERT(expected.at(u, v) == 77 || layer.grid().at(u, v) == expected.at(u, v));
      RC_ASSERT(layer.grid().at(u, v) == kUnknownCost || visited.contains(u, v));
    }
}

RC_GTEST_PROP(ObstacleLayer, RotatingRobotAndGridRotatesTheMarks, ()) {
  const CostGrid shape(60, 60, kCell_m, -3.0, -3.0);
  ObstacleLayer layer(withoutFootprint(), {}, shape), turned(withoutFootprint(), {}, shape);
  const TPose2D pose = test::anyPose(4.0);
  const PlanarScan scan = test::anyScan(60, 5.0);
  layer.update(pose, {scan});
  turned.update({-pose.y, pose.x, pose.phi + test::kPi / 2}, {scan});
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x) RC_ASSERT(turned.grid().at(59 - y, x) == layer.grid().at(x, y));
}

}  // namespace
}  // namespace bslnav
