#include <bslnav/hardware/Watchdog.h>
#include <gtest/gtest.h>

#include <chrono>

#include "RecordingBase.h"

namespace bslnav {
namespace {

using Source = Watchdog::Source;

void sleepFor(double time_s) { std::this_thread::sleep_for(std::chrono::duration<double>(time_s)); }

TEST(Watchdog, LeavesABaseAloneWhoseLoopIsOnTime) {
  test::RecordingBase base;
  Watchdog watchdog(base, {5.0, 5.0, 5.0});
  base.drive({0.5, 0.0, 0.0});
  sleepFor(0.1);
  EXPECT_EQ(base.stops(), 0);
  EXPECT_EQ(watchdog.tripped(), "");
  EXPECT_EQ(base.command().vx, 0.5);
}

TEST(Watchdog, StopsTheBaseOfALoopThatStalls) {
  test::RecordingBase base;
  Watchdog watchdog(base, {0.1, 5.0, 5.0});
  base.drive({0.5, 0.0, 0.0});
  sleepFor(1.0);
  EXPECT_EQ(base.command().vx, 0.0);
  EXPECT_EQ(watchdog.tripped(), "the control loop");
  EXPECT_EQ(watchdog.tripped(), "");  // told once
  EXPECT_EQ(watchdog.trips(), 1);
}

TEST(Watchdog, ACommandThatComesWhileSomethingIsLateDoesNotLast) {
  test::RecordingBase base;
  Watchdog watchdog(base, {5.0, 0.1, 5.0});
  sleepFor(1.0);
  base.drive({0.5, 0.0, 0.0});
  sleepFor(1.0);
  EXPECT_EQ(base.command().vx, 0.0);
  EXPECT_EQ(watchdog.tripped(), "a sensor");
}

TEST(Watchdog, LetsGoOnWhenItIsHeardAgain) {
  test::RecordingBase base;
  Watchdog watchdog(base, {5.0, 5.0, 0.2});
  sleepFor(1.0);
  EXPECT_EQ(watchdog.tripped(), "the pose");
  for (int k = 0; k < 10; ++k) {
    watchdog.heard(Source::Pose);
    base.drive({0.5, 0.0, 0.0});
    sleepFor(0.02);
  }
  EXPECT_EQ(base.command().vx, 0.5);
}

}  // namespace
}  // namespace bslnav
