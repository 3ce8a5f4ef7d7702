#include <gtest/gtest.h>

#include <memory>

#include "RawlogReaderLogs.h"

namespace bslnav {
namespace {

using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservation3DRangeScan;
using testing_logs::kStart_s;
using testing_logs::LogWriter;
using testing_logs::makeDepth;
using testing_logs::makeScan;
using testing_logs::read;

TEST(RawlogReaderDepth, ADepthObservationAloneMakesAFrame) {
  const auto log = read(LogWriter("depth_alone").depth(0.0).add(makeDepth(0.2, "", 777)).close());
  ASSERT_EQ(log.frames.size(), 2u);
  ASSERT_EQ(log.frames[0].depth.size(), 1u);
  ASSERT_EQ(log.frames[1].depth.size(), 1u);
  EXPECT_TRUE(log.frames[0].scans.empty());
  EXPECT_EQ(log.frames[0].depth[0]->sensorLabel, "CAMERA");
  EXPECT_EQ(log.frames[0].depth[0]->rangeImage(23, 31), 1500);
  EXPECT_EQ(log.frames[1].depth[0]->rangeImage(23, 31), 777);
  EXPECT_NEAR(log.frames[1].time_s, 0.2, 1e-6);
  EXPECT_EQ(log.statistics.frames, 2u);
  EXPECT_EQ(log.statistics.depthFrames, 2u);
  EXPECT_EQ(log.statistics.scans, 0u);
  EXPECT_EQ(log.statistics.unusableBeams_percent(), 0.0);
}

TEST(RawlogReaderDepth, ASensoryFrameKeepsScansAndDepthTogether) {
  mrpt::obs::CSensoryFrame record;
  record.insert(std::make_shared<CObservation3DRangeScan>(makeDepth(0.08, "LEFT")));
  record.insert(std::make_shared<CObservation2DRangeScan>(makeScan(0.10)));
  record.insert(std::make_shared<CObservation3DRangeScan>(makeDepth(0.09, "RIGHT")));
  const auto log =
      read(LogWriter("depth_together").sensoryFrame(0.0).action({1, 0, 0}).add(record).close());
  ASSERT_EQ(log.frames.size(), 2u);
  const SensorFrame& frame = log.frames[1];
  ASSERT_EQ(frame.depth.size(), 2u);
  EXPECT_EQ(frame.depth[0]->sensorLabel, "LEFT");
  EXPECT_EQ(frame.depth[1]->sensorLabel, "RIGHT");
  EXPECT_EQ(frame.scans.size(), 1u);
  EXPECT_NEAR(frame.time_s, 0.10, 1e-6);  // the scan's: depth keeps its own, older stamp
  EXPECT_NEAR(mrpt::Clock::toDouble(frame.depth[0]->timestamp), kStart_s + 0.08, 1e-6);
  EXPECT_DOUBLE_EQ(frame.odometry.x, 1.0);
}

TEST(RawlogReaderDepth, ReadsScansAndDepthOfDifferentRates) {
  // A second of scans at 10 Hz and depth at 4 Hz while the robot drives along x with 1 m/s.
  LogWriter writer("rates");
  for (int i = 0; i <= 20; ++i) {  // every 0.05 s
    const double time_s = 0.05 * i;
    writer.odometry(time_s, {time_s, 0, 0});
    if (i % 2 == 0) writer.scan(time_s);
    if (i % 5 == 0) writer.depth(time_s);
  }
  const auto log = read(writer.close());
  EXPECT_EQ(log.statistics.scans, 11u);
  EXPECT_EQ(log.statistics.depthFrames, 5u);
  ASSERT_EQ(log.frames.size(), 16u);
  for (const SensorFrame& frame : log.frames) {
    EXPECT_EQ(frame.scans.size() + frame.depth.size(), 1u);
    EXPECT_NEAR(frame.odometry.x, frame.time_s, 1e-6);
  }
  EXPECT_NEAR(log.frames.back().twist.vx, 1.0, 1e-3);
  EXPECT_TRUE(log.statistics.clockJumps.empty());
}

TEST(RawlogReaderDepth, WaitsForOdometryAsScansDo) {
  const auto log = read(LogWriter("depth_odometry")
                            .odometry(0.0, {0, 0, 0})
                            .depth(0.1)
                            .odometry(0.4, {4, 0, 0})
                            .close());
  ASSERT_EQ(log.frames.size(), 1u);
  EXPECT_NEAR(log.frames[0].odometry.x, 1.0, 1e-5);  // a quarter of the way
}

TEST(RawlogReaderDepth, DropsAndCountsWhatHasNoRangeImage) {
  auto points = makeDepth(0.1), empty = makeDepth(0.2);
  points.hasRangeImage = false;
  points.hasPoints3D = true;
  points.resizePoints3DVectors(5);
  empty.rangeImage.setSize(0, 0);
  const auto log = read(LogWriter("no_image").depth(0.0).add(points).add(empty).scan(0.3).close());
  ASSERT_EQ(log.frames.size(), 2u);
  EXPECT_EQ(log.frames[1].scans.size(), 1u);
  EXPECT_EQ(log.statistics.depthFrames, 1u);
  EXPECT_EQ(log.statistics.droppedDepthFrames, 2u);
  EXPECT_EQ(log.statistics.firstDroppedDepth, "record 1: has no range image");
}

TEST(RawlogReaderDepth, ASensoryFrameKeepsItsScanWhenItsDepthIsDropped) {
  mrpt::obs::CSensoryFrame record;
  auto empty = makeDepth(0.0);
  empty.hasRangeImage = false;
  record.insert(std::make_shared<CObservation3DRangeScan>(empty));
  record.insert(std::make_shared<CObservation2DRangeScan>(makeScan(0.0)));
  const auto log = read(LogWriter("dropped_beside_scan").add(record).close());
  ASSERT_EQ(log.frames.size(), 1u);
  EXPECT_EQ(log.frames[0].scans.size(), 1u);
  EXPECT_TRUE(log.frames[0].depth.empty());
}

TEST(RawlogReaderDepth, PassesOnAnImageWithoutCalibration) {
  auto depth = makeDepth(0.0);
  depth.cameraParams.setIntrinsicParamsFromValues(0.0, 0.0, 0.0, 0.0);
  const auto log = read(LogWriter("uncalibrated").add(depth).close());
  ASSERT_EQ(log.frames.size(), 1u);
  EXPECT_EQ(log.frames[0].depth[0]->cameraParams.fx(), 0.0);
  EXPECT_EQ(log.statistics.droppedDepthFrames, 0u);
}

TEST(RawlogReaderDepth, GivesDepthWithoutTimeStampTheTimeOfTheFrameBefore) {
  const auto log = read(LogWriter("depth_stamp").scan(0.0).scan(0.5).depth(std::nullopt).close());
  ASSERT_EQ(log.frames.size(), 3u);
  EXPECT_NEAR(log.frames[2].time_s, 0.5, 1e-6);
  EXPECT_NEAR(mrpt::Clock::toDouble(log.frames[2].depth[0]->timestamp), kStart_s + 0.5, 1e-6);
  EXPECT_EQ(log.statistics.missingTimeStamps, 1u);
}

TEST(RawlogReaderDepth, KeepsNoFrameAfterItHasBeenHandedOut) {
  LogWriter writer("released");
  for (int i = 0; i < 100; ++i) writer.depth(0.1 * i);
  RawlogReader reader(writer.close());
  SensorFrame frame;
  ASSERT_TRUE(reader.next(frame));
  const std::weak_ptr<const CObservation3DRangeScan> first = frame.depth[0];
  ASSERT_TRUE(reader.next(frame));
  EXPECT_TRUE(first.expired());
}

}  // namespace
}  // namespace bslnav
