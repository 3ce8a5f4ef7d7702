#pragma once

#include <bslnav/navigation/RawlogReader.h>
#include <mrpt/core/Clock.h>

#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "RawlogClock.h"
#include "RawlogOdometry.h"

namespace bslnav {

/** What one record of a log measured of the surroundings. */
struct RawlogMeasurements {
  std::vector<mrpt::obs::CObservation2DRangeScan::Ptr> scans;
  std::vector<mrpt::obs::CObservation3DRangeScan::Ptr> depth;

  bool empty() const { return scans.empty() && depth.empty(); }
};

/** Makes frames of what a log holds, in the order of the log, and counts. */
class RawlogFrames {
 public:
  /** @param imagesDirectory where the range images are that the log only names */
  RawlogFrames(double gap_s, std::string imagesDirectory, RawlogFraming framing)
      : imagesDirectory_(std::move(imagesDirectory)), framing_(framing), clock_(gap_s) {}

  /** Odometry since the last increment; `twist` if the log has one. Not used after an absolute
   * reading. */
  void addIncrement(const mrpt::math::TPose2D& increment,
                    const std::optional<mrpt::math::TTwist2D>& twist);
  /** Absolute odometry; not used after an increment. */
  void addReading(const mrpt::math::TPose2D& pose, std::optional<double> stamp_s,
                  const std::optional<mrpt::math::TTwist2D>& twist);
  /** Scans and depth of one instant: a frame, as soon as the odometry of their time is known. */
  void addMeasurements(RawlogMeasurements measurements);
  /** Where the robot was localised: the end of a recorded control cycle, and a frame if the framing
   * says so. */
  void addPose(const mrpt::math::TPose2D& mapFromRobot, mrpt::Clock::time_point stamp);
  /** Nothing follows: makes frames of what still waits for odometry. */
  void finish() { release(true); }

  RawlogStatistics statistics;
  std::deque<SensorFrame> ready;

 private:
  struct Waiting {
    std::size_t record;
    double stamp_s;
    RawlogMeasurements measurements;
  };

  bool countOdometry(const mrpt::math::TPose2D& pose);
  void release(bool all);
  void dropDepthWithoutImage(Waiting& released);
  void emit(const Waiting& released);
  void setTime(SensorFrame& frame, const Waiting& released, RawlogClock::Step step);
  void complete(SensorFrame& frame, const Waiting& released);
  void count(const SensorFrame& frame);

  std::string imagesDirectory_;
  RawlogFraming framing_;
  RawlogClock clock_;
  RawlogOdometry odometry_;
  TwistEstimator estimator_;
  std::optional<mrpt::math::TTwist2D> reported_;
  std::deque<Waiting> waiting_;
  RawlogMeasurements cycle_;                       // since the last recorded pose
  std::optional<mrpt::Clock::time_point> origin_;  // stamp of the first recorded pose
  double lastStamp_s_ = 0.0;                       // of any observation
  mrpt::math::TPose2D lastOdometry_;               // of the frame before
};

}  // namespace bslnav
