#include <bslnav/evaluation/RunTrace.h>
#include <bslnav/evaluation/Thinning.h>
#include <gtest/gtest.h>

#include "EvaluationRig.h"

namespace bslnav::test {
namespace {

TEST(Thinning, KeepsEveryCycleUntilThereAreTooMany) {
  Thinning thinning;
  for (std::size_t i = 0; i < Thinning::kMost; ++i) {
    ASSERT_FALSE(thinning.isFull(i));
    ASSERT_TRUE(thinning.keepsNext());
  }
  EXPECT_TRUE(thinning.isFull(Thinning::kMost));
  EXPECT_TRUE(thinning.keepsNext());
  EXPECT_FALSE(thinning.keepsNext());
  EXPECT_TRUE(thinning.keepsNext());
}

TEST(Thinning, HalvingKeepsTheFirst) {
  std::vector<int> none, odd{1, 2, 3}, even{1, 2, 3, 4};
  for (auto* values : {&none, &odd, &even}) Thinning::halve(*values);
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(odd, (std::vector<int>{1, 3}));
  EXPECT_EQ(even, (std::vector<int>{1, 3}));
}

/** 0.1 m a cycle, somebody starts to walk in cycle 100; 20000 cycles are three times as many as are
 * kept, so every fourth is. */
TEST(RunTrace, OfALongRunIsThinned) {
  const SimulationSetup setup = hall();
  const NavigationCycle cycle(setup.navigation, nullptr);
  RunTrace trace;
  SimulationState truth;
  truth.people.resize(1);
  for (int i = 0; i < 20000; ++i) {
    truth.time_s = i;
    truth.pose.x = 0.1 * i;
    truth.people[0].started = i >= 100;
    trace.observe({CycleRecord(), truth, cycle, SensorFrame()}, {});
  }
  EXPECT_EQ(trace.time_s.size(), 5000u);
  for (const std::size_t i : {0u, 1u, 2u, 4999u}) {
    const auto k = static_cast<double>(4 * i);
    EXPECT_EQ(trace.time_s[i], k);
    EXPECT_NEAR(trace.positions[i].x, 0.1 * k, 1e-9);
    EXPECT_NEAR(trace.distance_m[i], 0.1 * k, 1e-6);
  }
  EXPECT_EQ(trace.walks[0].size(), 5000u);
  EXPECT_EQ(trace.walkStarts[0], 25u);
  EXPECT_NEAR(trace.lastPose.x, 1999.9, 1e-6);
}

}  // namespace
}  // namespace bslnav::test
