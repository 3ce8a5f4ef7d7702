#pragma once

#include <bslnav/navigation/RawlogReader.h>
#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bslnav::testing_logs {

inline constexpr double kStart_s = 1.0e9;  ///< when the logs begin, since the epoch of MRPT's clock

/** A scan of four beams, three of them usable, at a time since kStart_s; without time stamp if
 * there is none. */
inline mrpt::obs::CObservation2DRangeScan makeScan(std::optional<double> time_s,
                                                   const std::string& label = "LASER") {
  mrpt::obs::CObservation2DRangeScan scan;
  scan.sensorLabel = label;
  scan.timestamp = time_s ? mrpt::Clock::fromDouble(kStart_s + *time_s) : INVALID_TIMESTAMP;
  scan.resizeScanAndAssign(4, 2.0f, true);
  scan.setScanRangeValidity(3, false);
  return scan;
}

/** A calibrated depth observation of 32 × 24 pixels, all at the same depth. */
inline mrpt::obs::CObservation3DRangeScan makeDepth(std::optional<double> time_s,
                                                    const std::string& label = "CAMERA",
                                                    std::uint16_t depth_mm = 1500) {
  mrpt::obs::CObservation3DRangeScan depth;
  depth.sensorLabel = label;
  depth.timestamp = time_s ? mrpt::Clock::fromDouble(kStart_s + *time_s) : INVALID_TIMESTAMP;
  depth.cameraParams.ncols = 32;
  depth.cameraParams.nrows = 24;
  depth.cameraParams.setIntrinsicParamsFromValues(30.0, 30.0, 15.5, 11.5);
  depth.hasRangeImage = true;
  depth.rangeImage_setSize(24, 32);
  depth.rangeImage.fill(depth_mm);
  return depth;
}

/** Writes a small rawlog record by record; close() before reading it. */
class LogWriter {
 public:
  explicit LogWriter(const std::string& name, int compression = 1)
      : path_(testing::TempDir() + "bslnav_" + name + ".rawlog"),
        stream_(path_, mrpt::io::OpenMode::TRUNCATE, compression) {}

  LogWriter& add(const mrpt::serialization::CSerializable& object) {
    mrpt::serialization::archiveFrom(stream_) << object;
    return *this;
  }
  LogWriter& scan(std::optional<double> time_s, const std::string& label = "LASER") {
    return add(makeScan(time_s, label));
  }
  LogWriter& depth(std::optional<double> time_s, const std::string& label = "CAMERA") {
    return add(makeDepth(time_s, label));
  }
  LogWriter& odometry(double time_s, const mrpt::math::TPose2D& pose) {
    mrpt::obs::CObservationOdometry reading;
    reading.timestamp = mrpt::Clock::fromDouble(kStart_s + time_s);
    reading.odometry = mrpt::poses::CPose2D(pose);
    return add(reading);
  }
  LogWriter& action(const mrpt::math::TPose2D& increment,
                    const std::optional<mrpt::math::TTwist2D>& twist = std::nullopt) {
    mrpt::obs::CActionRobotMovement2D movement;
    movement.computeFromOdometry(mrpt::poses::CPose2D(increment), {});
    movement.hasVelocities = twist.has_value();
    movement.velocityLocal = twist.value_or(mrpt::math::TTwist2D{});
    mrpt::obs::CActionCollection actions;
    actions.insert(movement);
    return add(actions);
  }
  LogWriter& sensoryFrame(double time_s) {
    mrpt::obs::CSensoryFrame frame;
    frame.insert(std::make_shared<mrpt::obs::CObservation2DRangeScan>(makeScan(time_s)));
    return add(frame);
  }
  /** @return the file's path */
  std::string close() {
    stream_.close();
    return path_;
  }

 private:
  std::string path_;
  mrpt::io::CFileGZOutputStream stream_;
};

/** Everything that a log gives. */
struct Log {
  std::vector<SensorFrame> frames;
  RawlogStatistics statistics;
};

inline Log read(const std::string& file, double gap_s = 2.0) {
  RawlogReader reader(file, gap_s);
  Log log;
  for (SensorFrame frame; reader.next(frame);) log.frames.push_back(frame);
  log.statistics = reader.statistics();
  return log;
}

}  // namespace bslnav::testing_logs
