#pragma once

#include <bslnav/navigation/SensorFrame.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace bslnav {

/** What a rawlog has held so far; record numbers count the objects of the file from 0. */
struct RawlogStatistics {
  struct ClockJump {
    std::size_t record = 0;
    double step_s = 0.0;  ///< negative: back; positive: a gap
  };

  std::size_t entries = 0;
  std::size_t frames = 0;
  std::size_t scans = 0;
  std::size_t depthFrames = 0;         ///< depth observations with a range image
  std::size_t droppedDepthFrames = 0;  ///< without one, or its file cannot be read
  std::string firstDroppedDepth;       ///< record, file and problem
  std::size_t beams = 0;
  std::size_t unusableBeams =
      0;  ///< marked invalid, not finite, not positive, or at the maximum range
  std::size_t odometryEntries = 0;  ///< usable ones
  std::size_t droppedOdometry = 0;  ///< not finite
  std::size_t equalTimeStamps = 0;  ///< frames no later than the one before
  std::size_t missingTimeStamps = 0;
  std::vector<ClockJump> clockJumps;
  double duration_s = 0.0;
  double pathLength_m = 0.0;  ///< of the odometry, without what lies in gaps
  bool hasOdometry = false;
  bool truncated = false;  ///< the file ends inside a record, or with one that nothing can read
  std::size_t truncatedAtRecord = 0;

  double unusableBeams_percent() const {
    return beams == 0 ? 0.0
                      : 100.0 * static_cast<double>(unusableBeams) / static_cast<double>(beams);
  }
};

/** What makes a frame of a log. */
enum class RawlogFraming {
  Measurements,  ///< every 2D scan, depth observation or sensory frame
  RecordedPoses  ///< every CObservationRobotPose: a control cycle of the recorded run, with what
                 ///< was logged since the one before
};

/** Streams the frames of an MRPT rawlog, compressed or not; `RawlogFraming` says what a frame is.
 *
 * Reads both formats: action and sensory frame pairs (odometry increments are summed) and single
 * observations (odometry is interpolated at their time). Range images that the log stores outside
 * are read from the directory that MRPT expects beside it, `<log without extension>_Images`; a
 * depth observation without range image is dropped and counted, its points are not used. The twist
 * is the action's where it has one, else it comes from odometry differences. A frame without a time
 * stamp takes the time of the one before; after a clock that went back, time goes on from there.
 * Ranges are passed on as they are, NaN and zero included.
 *
 * With `RawlogFraming::RecordedPoses` a frame has the recorded pose as `mapFromRobot`, its time to
 * the 100 ns of MRPT's clock, and the last odometry reading before it, with its twist, as it is. */
class RawlogReader {
 public:
  /** Opens the log and reads up to its first frame.
   *  @param gap_s a step of the clock above it is a gap (SensorFrame::afterGap)
   *  @throws Error when the file is missing, empty, not a rawlog, or without anything that makes a
   * frame */
  explicit RawlogReader(const std::string& file, double gap_s = 2.0,
                        RawlogFraming framing = RawlogFraming::Measurements);
  ~RawlogReader();
  RawlogReader(RawlogReader&&) noexcept;
  RawlogReader& operator=(RawlogReader&&) noexcept;

  /** Puts the next frame into `frame`; false, and `frame` as it was, after the last one. */
  bool next(SensorFrame& frame);

  /** Of what has been read until now: complete after next() has returned false. */
  const RawlogStatistics& statistics() const;

 private:
  struct Stream;
  std::unique_ptr<Stream> stream_;
};

}  // namespace bslnav
