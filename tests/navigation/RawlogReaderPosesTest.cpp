#include <bslnav/config/Error.h>
#include <gmock/gmock.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include "RawlogReaderLogs.h"

namespace bslnav {
namespace {

using testing_logs::kStart_s;
using testing_logs::LogWriter;

/** A recorded control cycle, after its measurements: odometry at (x, 0, 0) with 0.5 m/s, localised
 * at (x + 10, 1, 0.1). */
LogWriter& endCycle(LogWriter& log, long ticks, double x) {
  const auto stamp = mrpt::Clock::fromDouble(kStart_s) + mrpt::Clock::duration(ticks);
  mrpt::obs::CObservationOdometry odometry;
  odometry.timestamp = stamp;
  odometry.odometry = mrpt::poses::CPose2D(x, 0.0, 0.0);
  odometry.hasVelocities = true;
  odometry.velocityLocal = {0.5, 0.0, 0.25};
  mrpt::obs::CObservationRobotPose pose;
  pose.timestamp = stamp;
  pose.pose.mean = mrpt::poses::CPose3D(x + 10.0, 1.0, 0.0, 0.1, 0.0, 0.0);
  return log.add(odometry).add(pose);
}

std::vector<SensorFrame> cyclesOf(const std::string& file) {
  RawlogReader reader(file, 2.0, RawlogFraming::RecordedPoses);
  std::vector<SensorFrame> frames;
  for (SensorFrame frame; reader.next(frame);) frames.push_back(frame);
  return frames;
}

TEST(RawlogReaderPoses, ARecordedPoseEndsAFrame) {
  LogWriter log("poses_frames");
  endCycle(log.scan(0.0, "left").scan(0.0, "right").depth(0.0), 0, 0.0);
  endCycle(log, 1000000, 0.05);
  endCycle(log.scan(0.15, "left"), 2000000, 0.1);
  const auto frames = cyclesOf(log.close());
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_EQ(frames[0].scans.size(), 2U);
  EXPECT_EQ(frames[0].depth.size(), 1U);
  EXPECT_EQ(frames[1].scans.size(), 0U);
  EXPECT_EQ(frames[2].scans.size(), 1U);
  EXPECT_EQ(frames[2].odometry.x, 0.1);
  EXPECT_EQ(frames[2].mapFromRobot.x, 10.1);
  EXPECT_NEAR(frames[2].mapFromRobot.phi, 0.1, 1e-15);
  EXPECT_EQ(frames[2].twist, (mrpt::math::TTwist2D{0.5, 0.0, 0.25}));
}

/* Seconds since the epoch as a double are exact to 0.12 us only, and from fromDouble() to 1.6 us.
 */
TEST(RawlogReaderPoses, TimesAreThoseOfTheStampsToTheTick) {
  LogWriter log("poses_times");
  for (const long ticks : {0L, 1000000L, 1000001L, 12345678L}) endCycle(log, ticks, 0.0);
  const auto frames = cyclesOf(log.close());
  ASSERT_EQ(frames.size(), 4U);
  EXPECT_NEAR(frames[1].time_s, 0.1, 1e-12);
  EXPECT_NEAR(frames[2].time_s, 0.1000001, 1e-12);
  EXPECT_NEAR(frames[3].time_s, 1.2345678, 1e-12);
  for (const auto& frame : frames) EXPECT_EQ(frame.startTime_s, kStart_s);
}

TEST(RawlogReaderPoses, AGapOfTheClockIsOne) {
  LogWriter log("poses_gap");
  endCycle(log, 0, 0.0);
  endCycle(log, 50000000, 0.0);  // 5 s
  endCycle(log, 51000000, 0.0);
  const auto frames = cyclesOf(log.close());
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_TRUE(frames[1].afterGap);
  EXPECT_FALSE(frames[2].afterGap);
}

TEST(RawlogReaderPoses, WithoutThemPosesAreNotNeeded) {
  LogWriter log("poses_ignored");
  endCycle(log.scan(0.0), 0, 0.0);
  endCycle(log.scan(0.1), 1000000, 0.05);
  const auto frames = testing_logs::read(log.close()).frames;
  ASSERT_EQ(frames.size(), 2U);  // of the scans
  EXPECT_EQ(frames[1].mapFromRobot, frames[1].odometry);
}

TEST(RawlogReaderPoses, ALogWithoutThemIsRefused) {
  LogWriter log("poses_none");
  const std::string file = log.scan(0.0).odometry(0.0, {}).close();
  try {
    cyclesOf(file);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("has no recorded pose in 2 records"));
  }
}

}  // namespace
}  // namespace bslnav
