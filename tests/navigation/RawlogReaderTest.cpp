#include <bslnav/navigation/RawlogReader.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "RawlogReaderLogs.h"

namespace bslnav {
namespace {

using testing_logs::LogWriter;
using testing_logs::makeScan;
using testing_logs::read;

TEST(RawlogReader, SumsOdometryIncrementsOfActions) {
  // A metre ahead, a quarter turn to the left, two metres ahead: (1, 2) facing y.
  const auto log = read(LogWriter("increments")
                            .action({1, 0, 0})
                            .sensoryFrame(0.0)
                            .action({0, 0, M_PI / 2})
                            .action({2, 0, 0})
                            .sensoryFrame(1.0)
                            .close());
  ASSERT_EQ(log.frames.size(), 2u);
  EXPECT_NEAR(log.frames[0].odometry.x, 1.0, 1e-9);
  EXPECT_NEAR(log.frames[1].odometry.x, 1.0, 1e-9);
  EXPECT_NEAR(log.frames[1].odometry.y, 2.0, 1e-9);
  EXPECT_NEAR(log.frames[1].odometry.phi, M_PI / 2, 1e-9);
  EXPECT_NEAR(log.statistics.pathLength_m, 2.0, 1e-9);  // between the frames
  EXPECT_EQ(log.statistics.odometryEntries, 3u);
}

TEST(RawlogReader, KeepsASensoryFrameBeforeTheFirstAction) {
  EXPECT_EQ(read(LogWriter("early").sensoryFrame(0.0).action({1, 0, 0}).sensoryFrame(0.2).close())
                .frames.size(),
            2u);
}

TEST(RawlogReader, InterpolatesOdometryAtTheTimeOfTheScan) {
  // The scan is a quarter of the way from the first reading to the second; 3.0 → −3.0 rad leads
  // over π: 3.0 + 0.2832 / 4.
  const auto log = read(LogWriter("interpolated")
                            .odometry(0.0, {0, 0, 3.0})
                            .scan(0.1)
                            .odometry(0.4, {4, 8, -3.0})
                            .close());
  ASSERT_EQ(log.frames.size(), 1u);
  EXPECT_NEAR(log.frames[0].odometry.x, 1.0, 1e-5);
  EXPECT_NEAR(log.frames[0].odometry.y, 2.0, 1e-5);
  EXPECT_NEAR(log.frames[0].odometry.phi, 3.0 + (2 * M_PI - 6.0) / 4, 1e-5);
}

TEST(RawlogReader, HoldsTheLastOdometryAfterItsEnd) {
  const auto log =
      read(LogWriter("held").odometry(0.0, {5, 0, 0}).scan(0.0).scan(0.2).scan(0.4).close());
  ASSERT_EQ(log.frames.size(), 3u);
  EXPECT_DOUBLE_EQ(log.frames[2].odometry.x, 5.0);
}

TEST(RawlogReader, GivesTheTwistOfAnArcFromOdometryDifferences) {
  // v = 0.5 m/s, ω = 0.4 rad/s for 0.5 s: radius 1.25 m, angle 0.2 rad; the chord is not along x,
  // the twist is.
  const double r = 1.25, angle = 0.2;
  const auto log = read(LogWriter("arc")
                            .sensoryFrame(0.0)
                            .action({r * std::sin(angle), r * (1 - std::cos(angle)), angle})
                            .sensoryFrame(0.5)
                            .close());
  ASSERT_EQ(log.frames.size(), 2u);
  EXPECT_NEAR(log.frames[1].twist.vx, 0.5, 1e-5);
  EXPECT_NEAR(log.frames[1].twist.vy, 0.0, 1e-5);
  EXPECT_NEAR(log.frames[1].twist.omega, 0.4, 1e-5);
}

TEST(RawlogReader, SmoothsTheTwistALittle) {
  // From 0 to 1 m/s in one step of 0.1 s: the filter of 0.1 s takes half of it.
  const auto log = read(LogWriter("smooth")
                            .sensoryFrame(0.0)
                            .action({})
                            .sensoryFrame(0.1)
                            .action({0.1, 0, 0})
                            .sensoryFrame(0.2)
                            .close());
  ASSERT_EQ(log.frames.size(), 3u);
  EXPECT_NEAR(log.frames[2].twist.vx, 0.5, 1e-4);
}

TEST(RawlogReader, PrefersTheVelocitiesOfTheAction) {
  const auto log = read(LogWriter("velocities")
                            .sensoryFrame(0.0)
                            .action({0.1, 0, 0}, {{0.7, 0.0, -0.3}})
                            .sensoryFrame(0.1)
                            .close());
  ASSERT_EQ(log.frames.size(), 2u);
  EXPECT_DOUBLE_EQ(log.frames[1].twist.vx, 0.7);
  EXPECT_DOUBLE_EQ(log.frames[1].twist.omega, -0.3);
}

TEST(RawlogReader, RefusesVelocitiesThatNoRobotHas) {
  const auto log = read(LogWriter("garbage")
                            .sensoryFrame(0.0)
                            .action({0.1, 0, 0}, {{1e-40, 0.0, 7.5e31}})
                            .sensoryFrame(0.1)
                            .close());
  ASSERT_EQ(log.frames.size(), 2u);
  EXPECT_NEAR(log.frames[1].twist.vx, 1.0, 1e-4);  // 0.1 m in 0.1 s
  EXPECT_DOUBLE_EQ(log.frames[1].twist.omega, 0.0);
}

TEST(RawlogReader, ReadsALogWithoutOdometry) {
  const auto log = read(LogWriter("no_odometry").scan(0.0).scan(0.1).close());
  EXPECT_EQ(log.frames.size(), 2u);
  EXPECT_FALSE(log.statistics.hasOdometry);
  EXPECT_DOUBLE_EQ(log.statistics.pathLength_m, 0.0);
}

TEST(RawlogReader, HandsOutScansEarlyWhenOdometryNeverComes) {
  // 32 scans may wait for odometry: the frames come while reading, not all at the end.
  LogWriter writer("waiting");
  for (int i = 0; i < 100; ++i) writer.scan(0.1 * i);
  RawlogReader reader(writer.close());
  SensorFrame frame;
  ASSERT_TRUE(reader.next(frame));
  EXPECT_EQ(reader.statistics().entries, 33u);
}

TEST(RawlogReader, DropsAndCountsOdometryThatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto log = read(LogWriter("nan_odometry")
                            .odometry(0.0, {1, 2, 0})
                            .odometry(0.1, {nan, 2, 0})
                            .scan(0.1)
                            .close());
  ASSERT_EQ(log.frames.size(), 1u);
  EXPECT_DOUBLE_EQ(log.frames[0].odometry.x, 1.0);
  EXPECT_EQ(log.statistics.droppedOdometry, 1u);
  EXPECT_EQ(log.statistics.odometryEntries, 1u);
}

TEST(RawlogReader, PassesOnAndCountsUnusableBeams) {
  // Of four beams one is NaN, one zero, one at the maximum range, and one is marked invalid by
  // makeScan().
  auto scan = makeScan(0.0);
  scan.setScanRange(0, std::numeric_limits<float>::quiet_NaN());
  scan.setScanRange(1, 0.0f);
  scan.setScanRange(2, scan.maxRange);
  const auto log = read(LogWriter("beams").add(scan).add(makeScan(0.1)).close());
  ASSERT_EQ(log.frames.size(), 2u);
  EXPECT_TRUE(std::isnan(log.frames[0].scans[0]->getScanRange(0)));
  EXPECT_DOUBLE_EQ(log.statistics.unusableBeams_percent(), 62.5);  // 4 + 1 of 8
}

TEST(RawlogReader, MakesOneFrameOfASensoryFrameWithTwoScans) {
  mrpt::obs::CSensoryFrame both;
  both.insert(std::make_shared<mrpt::obs::CObservation2DRangeScan>(makeScan(0.0, "FRONT")));
  both.insert(std::make_shared<mrpt::obs::CObservation2DRangeScan>(makeScan(0.0, "REAR")));
  const auto log = read(LogWriter("both").add(both).close());
  ASSERT_EQ(log.frames.size(), 1u);
  EXPECT_EQ(log.frames[0].scans.size(), 2u);
  EXPECT_EQ(log.statistics.scans, 2u);
}

}  // namespace
}  // namespace bslnav
