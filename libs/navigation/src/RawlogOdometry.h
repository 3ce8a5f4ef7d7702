#pragma once

#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>

namespace bslnav {

/** The odometry of a log: summed increments, or the last two absolute readings. */
class RawlogOdometry {
 public:
  void addIncrement(const mrpt::math::TPose2D& increment);
  /** @param stamp_s seconds since MRPT's epoch */
  void addReading(const mrpt::math::TPose2D& pose, double stamp_s);

  bool hasIncrement() const { return source_ == Source::Increments; }
  bool hasReading() const { return source_ == Source::Readings; }
  double latestStamp_s() const { return latest_.stamp_s; }
  /** Interpolated between the last two readings, the nearer one outside them. */
  mrpt::math::TPose2D poseAt(double stamp_s) const;

 private:
  enum class Source { None, Increments, Readings };
  struct Reading {
    double stamp_s = 0.0;
    mrpt::math::TPose2D pose;
  };
  Reading before_, latest_;
  Source source_ = Source::None;
};

/** The robot's twist from its poses over time, smoothed by a first-order filter. */
class TwistEstimator {
 public:
  /** The twist at a pose; times that stand still keep the twist. */
  mrpt::math::TTwist2D update(const mrpt::math::TPose2D& pose, double time_s);
  /** Starts again at a pose: nothing is known of the motion that led there. */
  void restart(const mrpt::math::TPose2D& pose, double time_s);

 private:
  mrpt::math::TPose2D pose_;
  double time_s_ = 0.0;
  mrpt::math::TTwist2D twist_;
  bool hasPose_ = false, hasTwist_ = false;
};

}  // namespace bslnav
