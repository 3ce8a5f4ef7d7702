#pragma once

#include <bslnav/hardware/CreateParameters.h>
#include <bslnav/hardware/CreateProtocol.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>

#include <cstdint>
#include <deque>

namespace bslnav {

/** The wheels of a velocity in the robot frame; vy, which they cannot drive, is left out. Where one
 * wheel would be too fast, both are slowed down, so that the curvature stays. */
CreateWheels wheelsOf(const mrpt::math::TTwist2D& command, const CreateParameters& parameters);

/** Where the robot is and how it moves, from what its encoders count. */
class CreateOdometry {
 public:
  explicit CreateOdometry(const CreateParameters& parameters);

  /** The first counts are the origin; `time_s` is of any clock that never goes back. */
  void add(std::uint16_t leftCounts, std::uint16_t rightCounts, double time_s);

  /** Odometry frame from robot. */
  const mrpt::math::TPose2D& pose() const { return pose_; }
  /** In the robot frame: the mean over the last 60 ms; right after a gap, over the gap. */
  mrpt::math::TTwist2D twist() const;

 private:
  struct Sample {
    double time_s, distance_m, turn_rad;  // since the first counts
    std::uint16_t leftCounts, rightCounts;
  };

  double metresPerCount_, wheelBase_m_;
  mrpt::math::TPose2D pose_;
  std::deque<Sample> samples_;  // ascending in time; only the first may be older than the window
};

}  // namespace bslnav
