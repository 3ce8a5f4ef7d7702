#pragma once

#include <mrpt/math/TPose2D.h>

#include <array>
#include <cstddef>

namespace bslnav {

/** Where the robot was in the last cycles, by its odometry: measurements arrive late, and the robot
 * has moved on. */
class MotionHistory {
 public:
  /** @param odometry finite; @param time_s not before that of the call before */
  void add(double time_s, const mrpt::math::TPose2D& odometry);
  /** Forgets everything: over a gap of the clock the odometry says nothing. */
  void clear() { count_ = 0; }

  /** The pose of the robot at a time, seen from its newest one: interpolated; the oldest known one
   * before that, no motion after the newest. */
  mrpt::math::TPose2D nowFromThen(double time_s) const;

 private:
  struct Sample {
    double time_s = 0.0;
    mrpt::math::TPose2D odometry;
  };
  static constexpr std::size_t kSamples = 64;

  const Sample& sample(std::size_t ago) const {
    return samples_[(next_ + kSamples - 1 - ago) % kSamples];
  }

  std::array<Sample, kSamples> samples_;
  std::size_t next_ = 0, count_ = 0;
};

}  // namespace bslnav
