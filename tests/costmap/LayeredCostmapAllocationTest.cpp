#include <bslnav/costmap/LayeredCostmap.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "CostmapTestTools.h"

namespace {
std::atomic<long> allocations{0};
}

// Not inlined, or GCC takes malloc and delete for a mismatched pair.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size ? size : 1)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

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
  const long before = allocations;
  ASSERT_GT(before, 0);  // the counter counts
  drive();
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace bslnav
