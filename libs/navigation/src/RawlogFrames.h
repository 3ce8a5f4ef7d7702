#pragma once

#include <bslnav/navigation/RawlogReader.h>

#include <deque>
#include <optional>
#include <vector>

#include "RawlogClock.h"
#include "RawlogOdometry.h"

namespace bslnav {

/** Makes frames of what a log holds, in the order of the log, and counts. */
class RawlogFrames {
 public:
  using Scans = std::vector<mrpt::obs::CObservation2DRangeScan::Ptr>;

  explicit RawlogFrames(double gap_s) : clock_(gap_s) {}

  /** Odometry since the last increment; `twist` if the log has one. Not used after an absolute
   * reading. */
  void addIncrement(const mrpt::math::TPose2D& increment,
                    const std::optional<mrpt::math::TTwist2D>& twist);
  /** Absolute odometry; not used after an increment. */
  void addReading(const mrpt::math::TPose2D& pose, std::optional<double> stamp_s,
                  const std::optional<mrpt::math::TTwist2D>& twist);
  /** One or more scans of one instant: a frame, as soon as the odometry of their time is known. */
  void addScans(Scans scans);
  /** Nothing follows: makes frames of the scans that still wait for odometry. */
  void finish() { release(true); }

  RawlogStatistics statistics;
  std::deque<SensorFrame> ready;

 private:
  struct Waiting {
    std::size_t record;
    double stamp_s;
    Scans scans;
  };

  bool countOdometry(const mrpt::math::TPose2D& pose);
  void release(bool all);
  void emit(const Waiting& released);
  void setTime(SensorFrame& frame, const Waiting& released);
  void count(const SensorFrame& frame);

  RawlogClock clock_;
  RawlogOdometry odometry_;
  TwistEstimator estimator_;
  std::optional<mrpt::math::TTwist2D> reported_;
  std::deque<Waiting> waiting_;
  double lastStamp_s_ = 0.0;          // of any observation
  mrpt::math::TPose2D lastOdometry_;  // of the frame before
};

}  // namespace bslnav
