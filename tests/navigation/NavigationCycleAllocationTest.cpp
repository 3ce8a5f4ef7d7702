#include <malloc.h>

#include <cstdlib>
#include <new>

#include "NavigationCycleRig.h"

namespace {
// Of the thread that runs the cycles: OpenCV's worker threads allocate when they first have work.
thread_local long allocations = 0, liveBlocks = 0, liveBytes = 0;
}  // namespace

// Not inlined, or GCC takes malloc and delete for a mismatched pair.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  ++liveBlocks;
  void* const memory = std::malloc(size ? size : 1);
  if (!memory) throw std::bad_alloc();
  liveBytes += static_cast<long>(malloc_usable_size(memory));
  return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  if (memory) --liveBlocks;
  liveBytes -= static_cast<long>(malloc_usable_size(memory));
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  operator delete(memory);
}

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
  const long before = allocations;
  ASSERT_GT(before, 0);  // the counter counts
  laps.lap();
  EXPECT_EQ(allocations, before);
}

TEST(NavigationCycle, HoldsNoMoreMemoryAfter2000Cycles) {
  Laps laps(1.0);
  for (int i = 0; i < 3; ++i) laps.lap();
  const long blocks = liveBlocks, bytes = liveBytes, allocatedBefore = allocations;
  for (int i = 0; i < 33; ++i) laps.lap();  // of 60 cycles
  EXPECT_GT(allocations, allocatedBefore);  // new paths
  EXPECT_EQ(liveBlocks, blocks);
  EXPECT_NEAR(static_cast<double>(liveBytes), static_cast<double>(bytes), 1000.0);  // malloc rounds
}

}  // namespace
}  // namespace bslnav
