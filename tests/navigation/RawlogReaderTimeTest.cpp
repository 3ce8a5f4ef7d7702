#include <bslnav/navigation/RawlogReader.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "RawlogReaderLogs.h"

namespace bslnav {
namespace {

using testing_logs::kStart_s;
using testing_logs::LogWriter;
using testing_logs::read;

constexpr double kStampTolerance_s =
    1e-6;  // ticks of MRPT's clock: 100 ns; steps of a double near 1e9 s: 120 ns

TEST(RawlogReaderTime, MarksAGapAndIntegratesNothingOverIt) {
  // Records 0 to 2 are scans at 0, 1 and 6 s; the odometry moves 3 m in the gap of 5 s and 1 m
  // before it.
  const auto log = read(LogWriter("gap")
                            .odometry(0.0, {0, 0, 0})
                            .scan(0.0)
                            .odometry(1.0, {1, 0, 0})
                            .scan(1.0)
                            .odometry(6.0, {4, 0, 0})
                            .scan(6.0)
                            .close());
  ASSERT_EQ(log.frames.size(), 3u);
  EXPECT_FALSE(log.frames[0].afterGap);
  EXPECT_FALSE(log.frames[1].afterGap);
  EXPECT_TRUE(log.frames[2].afterGap);
  EXPECT_NEAR(log.frames[2].time_s, 6.0, kStampTolerance_s);
  EXPECT_DOUBLE_EQ(log.frames[2].twist.vx, 0.0);
  EXPECT_NEAR(log.statistics.pathLength_m, 1.0, 1e-9);
  ASSERT_EQ(log.statistics.clockJumps.size(), 1u);
  EXPECT_EQ(log.statistics.clockJumps[0].record, 5u);
  EXPECT_NEAR(log.statistics.clockJumps[0].step_s, 5.0, kStampTolerance_s);
}

TEST(RawlogReaderTime, TakesTheGapAsAParameter) {
  const auto file = LogWriter("gap_parameter").scan(0.0).scan(5.0).close();
  EXPECT_TRUE(read(file, 4.9).frames[1].afterGap);
  EXPECT_FALSE(read(file, 5.1).frames[1].afterGap);
}

TEST(RawlogReaderTime, GoesOnFromTheSameTimeWhenTheClockGoesBack) {
  // 0, 10, then back to 4 and on to 4.5: time 0, 10, 10, 10.5; the start moves by 6 s so that scans
  // keep their age of 0.
  const auto log = read(LogWriter("back").scan(0.0).scan(10.0).scan(4.0).scan(4.5).close(), 20.0);
  ASSERT_EQ(log.frames.size(), 4u);
  EXPECT_TRUE(log.frames[2].afterGap);
  EXPECT_NEAR(log.frames[2].time_s, 10.0, kStampTolerance_s);
  EXPECT_FALSE(log.frames[3].afterGap);
  EXPECT_NEAR(log.frames[3].time_s, 10.5, kStampTolerance_s);
  EXPECT_NEAR(log.frames[3].startTime_s, kStart_s - 6.0, kStampTolerance_s);
  ASSERT_EQ(log.statistics.clockJumps.size(), 1u);
  EXPECT_EQ(log.statistics.clockJumps[0].record, 2u);
  EXPECT_NEAR(log.statistics.clockJumps[0].step_s, -6.0, kStampTolerance_s);
}

TEST(RawlogReaderTime, UsesOdometryFromBeforeForScansFromBeforeTheClockWentBack) {
  const auto log = read(LogWriter("back_odometry")
                            .odometry(9.9, {1, 0, 0})
                            .scan(10.0)
                            .odometry(4.0, {2, 0, 0})
                            .scan(4.0)
                            .close());
  ASSERT_EQ(log.frames.size(), 2u);
  EXPECT_DOUBLE_EQ(log.frames[0].odometry.x, 1.0);
  EXPECT_DOUBLE_EQ(log.frames[1].odometry.x, 2.0);
}

TEST(RawlogReaderTime, TakesTwoSensorsSlightlyOutOfOrderForNoJump) {
  const auto log =
      read(LogWriter("two").scan(0.00, "FRONT").scan(0.10, "REAR").scan(0.08, "FRONT").close());
  ASSERT_EQ(log.frames.size(), 3u);
  EXPECT_NEAR(log.frames[2].time_s, 0.10, kStampTolerance_s);
  EXPECT_TRUE(log.statistics.clockJumps.empty());
}

TEST(RawlogReaderTime, TakesACameraThatOvertakesALaserForNoJump) {
  // Two scans in a row are older than the depth frame before them, yet the laser's clock goes on.
  const auto log = read(LogWriter("overtaken")
                            .scan(0.00)
                            .depth(0.30)
                            .scan(0.20)
                            .scan(0.25)
                            .depth(0.40)
                            .scan(0.30)
                            .close());
  ASSERT_EQ(log.frames.size(), 6u);
  const double expected_s[] = {0.0, 0.3, 0.3, 0.3, 0.4, 0.4};
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(log.frames[i].time_s, expected_s[i], kStampTolerance_s) << i;
  EXPECT_TRUE(log.statistics.clockJumps.empty());
  EXPECT_EQ(log.statistics.equalTimeStamps, 3u);
}

TEST(RawlogReaderTime, TellsALaserAndACameraOfTheSameLabelApart) {
  const auto log = read(LogWriter("same_label").scan(0.0, "").depth(0.3, "").scan(0.2, "").close());
  EXPECT_TRUE(log.statistics.clockJumps.empty());
}

TEST(RawlogReaderTime, CountsOneJumpWhenTheClockOfAllSensorsGoesBack) {
  // Back by 6 s at the scan; the depth frame after it is 0.05 s older, which is out of order only.
  const auto log = read(LogWriter("all_back")
                            .scan(10.0)
                            .depth(10.1)
                            .scan(4.1)
                            .depth(4.05)
                            .scan(4.2)
                            .depth(4.15)
                            .close());
  ASSERT_EQ(log.frames.size(), 6u);
  ASSERT_EQ(log.statistics.clockJumps.size(), 1u);
  EXPECT_EQ(log.statistics.clockJumps[0].record, 2u);
  EXPECT_NEAR(log.frames[5].time_s, 0.2, kStampTolerance_s);  // 0.1 before the jump, 0.1 after it
}

TEST(RawlogReaderTime, GoesOnAfterOneStampFarAhead) {
  // The depth frame is an hour ahead, by mistake: a jump there, one back, and time does not stand.
  const auto log =
      read(LogWriter("ahead").scan(0.0).depth(3600.0).scan(0.1).scan(0.2).depth(0.25).close());
  ASSERT_EQ(log.frames.size(), 5u);
  EXPECT_EQ(log.statistics.clockJumps.size(), 2u);
  EXPECT_NEAR(log.frames[4].time_s - log.frames[2].time_s, 0.15, kStampTolerance_s);
}

TEST(RawlogReaderTime, KeepsTimeAndTwistOverEqualTimeStamps) {
  const auto log = read(LogWriter("equal")
                            .sensoryFrame(0.0)
                            .action({0.1, 0, 0})
                            .sensoryFrame(0.1)
                            .action({0.1, 0, 0})
                            .sensoryFrame(0.1)
                            .close());
  ASSERT_EQ(log.frames.size(), 3u);
  EXPECT_EQ(log.frames[2].time_s, log.frames[1].time_s);
  EXPECT_NEAR(log.frames[2].twist.vx, 1.0, 1e-4);  // 0.1 m in 0.1 s
  EXPECT_EQ(log.statistics.equalTimeStamps, 1u);
}

TEST(RawlogReaderTime, GivesScansWithoutTimeStampTheTimeOfTheFrameBefore) {
  const auto log = read(LogWriter("missing").scan(0.0).scan(0.5).scan(std::nullopt).close());
  ASSERT_EQ(log.frames.size(), 3u);
  EXPECT_NEAR(log.frames[2].time_s, 0.5, kStampTolerance_s);
  EXPECT_NEAR(mrpt::Clock::toDouble(log.frames[2].scans[0]->timestamp), kStart_s + 0.5,
              kStampTolerance_s);
  EXPECT_EQ(log.statistics.missingTimeStamps, 1u);
  EXPECT_TRUE(log.statistics.clockJumps.empty());
}

/** Whatever the clock did: one frame a scan, in order, and a time that never decreases. */
RC_GTEST_PROP(RawlogReaderTime, TimeNeverDecreases, ()) {
  const auto ticks = *rc::gen::container<std::vector<int>>(12, rc::gen::inRange(-20, 60));
  LogWriter writer("law");
  for (const int tick : ticks)
    writer.scan(tick < -15 ? std::nullopt : std::optional<double>(0.1 * tick));
  const auto log = read(writer.close());
  RC_ASSERT(log.frames.size() == ticks.size());
  for (std::size_t i = 1; i < log.frames.size(); ++i) {
    RC_ASSERT(log.frames[i].time_s >= log.frames[i - 1].time_s);
    const double age_s =
        log.frames[i].time_s -
        (mrpt::Clock::toDouble(log.frames[i].scans[0]->timestamp) - log.frames[i].startTime_s);
    RC_ASSERT(std::abs(age_s) < kStampTolerance_s);
  }
}

/** The same with a camera beside the laser; what was overtaken may be older than its frame. */
RC_GTEST_PROP(RawlogReaderTime, TimeNeverDecreasesWithTwoSensors, ()) {
  const auto ticks = *rc::gen::container<std::vector<int>>(12, rc::gen::inRange(-20, 60));
  const auto fromCamera = *rc::gen::container<std::vector<bool>>(12, rc::gen::arbitrary<bool>());
  LogWriter writer("law_two");
  for (std::size_t i = 0; i < ticks.size(); ++i)
    fromCamera[i] ? writer.depth(0.1 * ticks[i]) : writer.scan(0.1 * ticks[i]);
  const auto log = read(writer.close());
  RC_ASSERT(log.frames.size() == ticks.size());
  for (std::size_t i = 0; i < log.frames.size(); ++i) {
    const SensorFrame& frame = log.frames[i];
    RC_ASSERT(frame.depth.size() == (fromCamera[i] ? 1u : 0u));
    if (i > 0) RC_ASSERT(frame.time_s >= log.frames[i - 1].time_s);
    const auto stamp = fromCamera[i] ? frame.depth[0]->timestamp : frame.scans[0]->timestamp;
    const double age_s = frame.time_s - (mrpt::Clock::toDouble(stamp) - frame.startTime_s);
    RC_ASSERT(age_s > -kStampTolerance_s);
    RC_ASSERT(age_s < 0.5);  // what is older is a clock that went back
  }
}

}  // namespace
}  // namespace bslnav
