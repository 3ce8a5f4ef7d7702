#include "../support/HeapUse.h"
#include "NavigationCycleRig.h"

namespace bslnav {
namespace {

/** Frames of a drive of 6 s past a box, with one scan, none (a slow laser) or two of them. */
std::vector<SensorFrame> framesOfADrive() {
  test::CycleRig rig(test::method(2), test::makeMap(-2.0, -2.0, 8.0, 2.0));
  rig.range_m = [](int bearing_deg) { return std::abs(bearing_deg - 50) < 10 ? 1.5 : 4.0; };
  rig.cycle.setGoals({{6.0, 0.0, 0.0}});
  std::vector<SensorFrame> frames;
  for (int i = 0; i < 60; ++i) {
    frames.push_back(rig.frame());
    rig.step(frames.back());
    if (i % 3 == 1) frames.back().scans.clear();
    if (i % 3 == 2) frames.back().scans.push_back(frames.back().scans[0]);
  }
  return frames;
}

/** Drives the frames once more, `lap` laps later. */
class Laps {
 public:
  explicit Laps(double replanPeriod_s)
      : cycle_(parameters(replanPeriod_s), test::makeMap(-2.0, -2.0, 8.0, 2.0)) {
    cycle_.setGoals({{7.0, 0.0, 0.0}});
  }
  void lap() {
    for (SensorFrame& frame : frames_) {
      cycle_.step(frame);
      frame.time_s += 6.0;  // the stamps of the scans stay: the clock began earlier
      frame.startTime_s -= 6.0;
    }
  }

 private:
  static NavigationParameters parameters(double replanPeriod_s) {
    NavigationParameters p = test::method(2);
    p.cycle.replanPeriod_s = replanPeriod_s;
    p.recovery.enabled = false;  // the robot of the frames does not do what it is told
    p.dwa.speedSamples = 4;
    p.dwa.yawRateSamples = 9;
    return p;
  }
  std::vector<SensorFrame> frames_ = framesOfADrive();
  NavigationCycle cycle_;
};

TEST(NavigationCycle, AllocatesNothingOnceWarmBetweenNewPaths) {
  Laps laps(1000.0);
  laps.lap();
  laps.lap();
  const long before = test::heapUse().allocations;
  ASSERT_GT(before, 0);  // the counter counts
  laps.lap();
  EXPECT_EQ(test::heapUse().allocations, before);
}

TEST(NavigationCycle, HoldsNoMoreMemoryAfter2000Cycles) {
  Laps laps(1.0);
  for (int i = 0; i < 3; ++i) laps.lap();
  const long blocks = test::heapUse().blocks, bytes = test::heapUse().bytes,
             allocatedBefore = test::heapUse().allocations;
  for (int i = 0; i < 33; ++i) laps.lap();                  // of 60 cycles
  EXPECT_GT(test::heapUse().allocations, allocatedBefore);  // new paths
  EXPECT_EQ(test::heapUse().blocks, blocks);
  EXPECT_NEAR(static_cast<double>(test::heapUse().bytes), static_cast<double>(bytes),
              1000.0);  // malloc rounds
}

}  // namespace
}  // namespace bslnav
