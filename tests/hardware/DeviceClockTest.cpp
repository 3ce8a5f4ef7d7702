#include <bslnav/hardware/DeviceClock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace bslnav {
namespace {

constexpr double kStart_s = 1.7e9;  // where a clock of today stands; its resolution there is 0.2 us
constexpr double kTolerance_s = 1e-6;

TEST(DeviceClock, TakesWhatCameSoonestForTheDifference) {
  DeviceClock clock;
  EXPECT_NEAR(clock.stamp_s(1000, kStart_s + 0.030), kStart_s + 0.030, kTolerance_s);
  EXPECT_NEAR(clock.stamp_s(1020, kStart_s + 0.025), kStart_s + 0.025, kTolerance_s);
  // 1020 is 0.025, so 1040 is 0.045, and by the drift 0.005 * 20 ms = 0.1 ms more.
  EXPECT_NEAR(clock.stamp_s(1040, kStart_s + 0.300), kStart_s + 0.0451, kTolerance_s);
}

TEST(DeviceClock, FollowsAClockThatGoesSlow) {
  DeviceClock clock;
  double stamp_s = 0.0, now_s = kStart_s;
  for (std::uint32_t device_ms = 0; device_ms < 600000; device_ms += 20) {
    now_s = kStart_s + 1.003e-3 * device_ms;
    stamp_s = clock.stamp_s(device_ms, now_s);
  }
  EXPECT_NEAR(stamp_s, now_s, 0.001);  // 1.8 s off, were the difference kept
}

TEST(DeviceClock, MindsNoOverflow) {
  DeviceClock clock;
  clock.stamp_s(4294967290U, kStart_s);
  EXPECT_NEAR(clock.stamp_s(14, kStart_s + 0.5), kStart_s + 0.0201, kTolerance_s);  // 20 ms later
}

TEST(DeviceClock, BeginsAnewWithADeviceThatDoes) {
  DeviceClock clock;
  clock.stamp_s(60000, kStart_s);
  EXPECT_NEAR(clock.stamp_s(5, kStart_s + 2.0), kStart_s + 2.0, kTolerance_s);
  EXPECT_NEAR(clock.stamp_s(25, kStart_s + 2.1), kStart_s + 2.0201, kTolerance_s);
}

TEST(DeviceClock, BelievesAJumpAheadAtOnce) {
  DeviceClock clock;
  clock.stamp_s(1000, kStart_s);
  EXPECT_NEAR(clock.stamp_s(3600000, kStart_s + 0.02), kStart_s + 0.02, kTolerance_s);
}

// A device that was off for 10 s and counts on where it was, or our clock was set ahead.
TEST(DeviceClock, BelievesADelayThatStays) {
  DeviceClock clock;
  clock.stamp_s(0, kStart_s);
  double now_s = kStart_s + 10.0, stamp_s = 0.0;
  for (std::uint32_t device_ms = 20; device_ms <= 700; device_ms += 20, now_s += 0.02)
    stamp_s = clock.stamp_s(device_ms, now_s + 0.02);
  EXPECT_NEAR(stamp_s, now_s, 0.001);
}

// A line that stood for 10 s and then gives all it held.
TEST(DeviceClock, BelievesNoDelayThatPasses) {
  DeviceClock clock;
  clock.stamp_s(0, kStart_s);
  for (std::uint32_t device_ms = 20; device_ms <= 10000; device_ms += 20)
    EXPECT_NEAR(clock.stamp_s(device_ms, kStart_s + 10.001), kStart_s + 1e-3 * device_ms,
                0.005 * 10.0 + kTolerance_s);  // the drift
}

RC_GTEST_PROP(DeviceClockLaw, NeverTellsTheFuture, ()) {
  DeviceClock clock;
  double now_s = kStart_s;
  for (int i = 0; i < 50; ++i) {
    now_s += *rc::gen::inRange(-1000, 3000) * 1e-3;
    RC_ASSERT(clock.stamp_s(*rc::gen::arbitrary<std::uint32_t>(), now_s) <= now_s);
  }
}

// Any delays of up to 0.1 s, the shortest among them none: stamps are right to the drift.
RC_GTEST_PROP(DeviceClockLaw, IsRightToTheDriftSinceTheShortestDelay, ()) {
  DeviceClock clock;
  const std::uint32_t first_ms = *rc::gen::arbitrary<std::uint32_t>();
  for (std::uint32_t i = 0; i < 50; ++i) {
    const double measured_s = kStart_s + 0.02 * i;
    const double delay_s = i == 0 ? 0.0 : *rc::gen::inRange(0, 100) * 1e-3;
    const double stamp_s = clock.stamp_s(first_ms + 20 * i, measured_s + delay_s);
    RC_ASSERT(stamp_s > measured_s - kTolerance_s);
    RC_ASSERT(stamp_s < measured_s + 0.02 * i * 0.005 + kTolerance_s);
  }
}

}  // namespace
}  // namespace bslnav
