#include <bslnav/costmap/LayeredCostmap.h>
#include <gtest/gtest.h>

#include "../support/HeapUse.h"
#include "CostmapTestTools.h"

namespace bslnav {
namespace {

TEST(LayeredCostmap, AllocatesNothingOnceWarm) {
  LayeredCostmap costmap({}, {}, nullptr, Extent::Rolling);
  std::vector<DangerZone> zones(3);
  for (auto& zone : zones) zone.radius_m = 1.0;
  std::vector<PlanarScan> scans;
  for (int i = 0; i < 8; ++i)
    scans.push_back(test::makeScan(std::vector<double>(360, 1.0 + 0.3 * i), 4.0));
  const auto drive = [&] {
    for (int i = 0; i < 50; ++i) costmap.update({0.03 * i, -0.02 * i, 0.1 * i}, scans, zones);
  };
  drive();
  const long before = test::heapUse().allocations;
  ASSERT_GT(before, 0);  // the counter counts
  drive();
  EXPECT_EQ(test::heapUse().allocations, before);
}

}  // namespace
}  // namespace bslnav
