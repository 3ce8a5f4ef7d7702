#include <bslnav/config/Error.h>
#include <bslnav/costmap/InflationLayer.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "CostmapTestTools.h"

namespace bslnav {
namespace {

constexpr double kResolution_m = 0.1;

struct Inflation {
  InflationParameters parameters;
  double inscribed_m = 0.0;
};

Inflation anyInflation() {
  Inflation any;
  any.parameters.radius_m = test::anyNumber(0.0, 1.4);
  any.parameters.scaling_per_m = test::anyNumber(0.0, 12.0);
  any.inscribed_m = test::anyNumber(0.0, 0.6);
  return any;
}

CostGrid inflated(const Inflation& inflation, const CostGrid& base) {
  CostGrid out = base;
  InflationLayer(inflation.parameters, inflation.inscribed_m, base.getResolution())
      .apply(base, base.bounds(), out);
  return out;
}

/** Every cell against every lethal cell, straight from the definition. */
CostGrid bruteForce(const Inflation& inflation, const CostGrid& base) {
  CostGrid out = base;
  for (int y = 0; y < base.height(); ++y)
    for (int x = 0; x < base.width(); ++x) {
      double nearest_m = 1e9;
      for (int v = 0; v < base.height(); ++v)
        for (int u = 0; u < base.width(); ++u)
          if (base.at(u, v) == kLethalCost)
            nearest_m = std::min(nearest_m, kResolution_m * std::hypot(u - x, v - y));
      Cost cost = kFreeCost;
      if (nearest_m <= inflation.inscribed_m)
        cost = kInscribedCost;
      else if (nearest_m <= inflation.parameters.radius_m)
        cost = static_cast<Cost>(252.0 * std::exp(-inflation.parameters.scaling_per_m *
                                                  (nearest_m - inflation.inscribed_m)));
      Cost& cell = out.at(x, y);
      if (cell == kUnknownCost)
        cell = cost >= kInscribedCost ? cost : kUnknownCost;
      else
        cell = std::max(cell, cost);
    }
  return out;
}

RC_GTEST_PROP(InflationLayer, EqualsBruteForce, ()) {
  const CostGrid base = test::anyBase(*rc::gen::inRange(1, 40), *rc::gen::inRange(1, 30),
                                      *rc::gen::element(2, 20, 200));
  const Inflation inflation = anyInflation();
  RC_ASSERT(test::same(inflated(inflation, base), bruteForce(inflation, base)));
}

RC_GTEST_PROP(InflationLayer, WindowHoldsWhatTheWholeGridHolds, ()) {
  const CostGrid base = test::anyBase(40, 30, 20);
  const Inflation inflation = anyInflation();
  const int x = *rc::gen::inRange(-5, 40), y = *rc::gen::inRange(-5, 30);
  const CellWindow window{x, y, x + *rc::gen::inRange(0, 30), y + *rc::gen::inRange(0, 30)};
  const CostGrid whole = inflated(inflation, base);
  CostGrid part(40, 30, kResolution_m, 0.0, 0.0, 77);
  InflationLayer(inflation.parameters, inflation.inscribed_m, kResolution_m)
      .apply(base, window, part);
  for (int v = 0; v < 30; ++v)
    for (int u = 0; u < 40; ++u)
      RC_ASSERT(part.at(u, v) == (window.contains(u, v) ? whole.at(u, v) : Cost{77}));
}

RC_GTEST_PROP(InflationLayer, MoreObstaclesNeverLowerACost, ()) {
  const CostGrid fewer = test::anyBase(30, 20, 30);
  CostGrid more = fewer;
  for (int i = *rc::gen::inRange(1, 5); i > 0; --i)
    more.at(*rc::gen::inRange(0, 30), *rc::gen::inRange(0, 20)) = kLethalCost;
  const Inflation inflation = anyInflation();
  const CostGrid with = inflated(inflation, more), without = inflated(inflation, fewer);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 30; ++x)
      RC_ASSERT(fewer.at(x, y) == kUnknownCost || with.at(x, y) >= without.at(x, y));
}

RC_GTEST_PROP(InflationLayer, RotatingTheObstaclesRotatesTheCosts, ()) {
  const int size = 25;
  const CostGrid base = test::anyBase(size, size, 20);
  const auto rotated = [](const CostGrid& grid) {
    CostGrid result = grid;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) result.at(size - 1 - y, x) = grid.at(x, y);
    return result;
  };
  const Inflation inflation = anyInflation();
  RC_ASSERT(test::same(inflated(inflation, rotated(base)), rotated(inflated(inflation, base))));
}

TEST(InflationLayer, GradedCostsAreTruncated) {
  const InflationLayer layer({1.0, 2.0}, 0.1, kResolution_m);
  EXPECT_EQ(layer.costAt(0), kLethalCost);
  EXPECT_EQ(layer.costAt(1), kInscribedCost);  // 0.1 m, the inscribed radius itself
  EXPECT_EQ(layer.costAt(4), 206);             // 252·exp(−2·0.1) = 206.32
  EXPECT_EQ(layer.costAt(36), 92);             // 252·exp(−2·0.5) = 92.71
  EXPECT_EQ(layer.costAt(100), 41);            // 1 m, the radius itself: 252·exp(−1.8) = 41.65
  EXPECT_EQ(layer.costAt(101), kFreeCost);
}

TEST(InflationLayer, InscribedRadiusCountsEvenBeyondTheInflationRadius) {
  const InflationLayer layer({0.1, 2.0}, 0.3, kResolution_m);
  EXPECT_EQ(layer.reach(), 3);
  EXPECT_EQ(layer.costAt(9), kInscribedCost);
}

TEST(InflationLayer, UnknownCellsBecomeInscribedButNotGraded) {
  CostGrid base(5, 1, kResolution_m, 0.0, 0.0, kUnknownCost);
  base.at(0, 0) = kLethalCost;
  const CostGrid out = inflated({{0.3, 1.0}, 0.1}, base);
  EXPECT_EQ(out.at(1, 0), kInscribedCost);
  EXPECT_EQ(out.at(2, 0), kUnknownCost);
}

TEST(InflationLayer, LargestReachIsExact) {
  CostGrid base(400, 3, kResolution_m, 0.0, 0.0);
  base.at(200, 1) = kLethalCost;
  const CostGrid out =
      inflated({{12.7, 0.0}, 0.1}, base);  // 127 cells, no decay: 252 up to the radius
  EXPECT_EQ(out.at(73, 1), kHighestGradedCost);
  EXPECT_EQ(out.at(72, 1), kFreeCost);
  EXPECT_EQ(out.at(73, 0), kFreeCost);  // sqrt(127² + 1) cells
}

TEST(InflationLayer, RefusesARadiusOfTooManyCells) {
  EXPECT_THROW(InflationLayer({12.9, 1.0}, 0.1, kResolution_m), Error);
}

}  // namespace
}  // namespace bslnav
