#include <bslnav/costmap/BlindSpotLayer.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "CostmapTestTools.h"

namespace bslnav {
namespace {

DangerZone zoneAt(double x, double y, double radius_m) {
  DangerZone zone;
  zone.centre = {x, y};
  zone.radius_m = radius_m;
  return zone;
}

TEST(BlindSpotLayer, CostFallsExponentiallyAndEndsAtTheRadius) {
  CostGrid costs(40, 1, 0.1, 0.0, 0.0);
  addDangerZones({zoneAt(0.05, 0.05, 1.02)}, costs);
  EXPECT_EQ(costs.at(0, 0), kHighestGradedCost);  // 253 at the centre, capped
  EXPECT_EQ(costs.at(5, 0), 153);                 // 253·exp(−0.5) = 153.45
  EXPECT_EQ(costs.at(10, 0), 93);                 // 253·exp(−1) = 93.07
  EXPECT_EQ(costs.at(11, 0), kFreeCost);          // 1.1 m
}

TEST(BlindSpotLayer, LeavesHigherCostsAlone) {
  CostGrid costs(4, 1, 0.1, 0.0, 0.0);
  costs.at(0, 0) = kLethalCost;
  costs.at(1, 0) = kInscribedCost;
  costs.at(2, 0) = kUnknownCost;
  addDangerZones({zoneAt(0.2, 0.05, 1.0)}, costs);
  EXPECT_EQ(costs.at(0, 0), kLethalCost);
  EXPECT_EQ(costs.at(1, 0), kInscribedCost);
  EXPECT_EQ(costs.at(2, 0), kUnknownCost);
  EXPECT_EQ(costs.at(3, 0), 217);  // 253·exp(−0.15) = 217.76
}

TEST(BlindSpotLayer, IgnoresZonesWithoutSizeOrPlace) {
  CostGrid costs(4, 4, 0.1, 0.0, 0.0);
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(addDangerZones({zoneAt(0.2, 0.2, 0.0), zoneAt(nan, 0.2, 1.0), zoneAt(0.2, 0.2, nan),
                              zoneAt(0.2, infinity, 1.0)},
                             costs)
                  .empty());
  EXPECT_EQ(std::count(costs.begin(), costs.end(), kFreeCost), 16);
}

TEST(BlindSpotLayer, ZoneFarAwayTouchesNothing) {
  CostGrid costs(4, 4, 0.1, 0.0, 0.0);
  EXPECT_TRUE(addDangerZones({zoneAt(1e12, -1e12, 1.0)}, costs).empty());
}

RC_GTEST_PROP(BlindSpotLayer, IsTheHighestOfWhatIsThereAndEquation10, ()) {
  const CostGrid before = test::anyBase(50, 30, 4);
  std::vector<DangerZone> zones;
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
    zones.push_back(
        zoneAt(test::anyNumber(-2.0, 7.0), test::anyNumber(-2.0, 5.0), test::anyNumber(0.0, 2.5)));
    zones.back().amplitude = test::anyNumber(0.0, 400.0);
    zones.back().scaling_per_m = test::anyNumber(0.0, 100.0);
  }
  CostGrid after = before;
  const CellWindow window = addDangerZones(zones, after);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 50; ++x) {
      double exact = 0.0;
      for (const auto& zone : zones) {
        const double l =
            std::hypot(before.idx2x(x) - zone.centre.x, before.idx2y(y) - zone.centre.y);
        if (l <= zone.radius_m)
          exact = std::max(exact, zone.amplitude * std::exp(-zone.scaling_per_m * l));
      }
      // Single precision may truncate to the other side of an integer.
      const auto expected = [&](double slack) {
        return std::max(before.at(x, y), static_cast<Cost>(std::clamp(exact + slack, 0.0, 252.0)));
      };
      RC_ASSERT(after.at(x, y) >= expected(-2e-3) && after.at(x, y) <= expected(2e-3));
      RC_ASSERT(after.at(x, y) == before.at(x, y) || window.contains(x, y));
    }
}

}  // namespace
}  // namespace bslnav
