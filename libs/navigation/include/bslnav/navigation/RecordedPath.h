#pragma once

#include <mrpt/math/TPose2D.h>

#include <vector>

namespace bslnav {

class Localization;
class RawlogReader;

/** Where the robot of a log was at every time: its future gives the goal of an offline evaluation.
 */
class RecordedPath {
 public:
  struct Sample {
    double time_s = 0.0;
    mrpt::math::TPose2D pose;  ///< map frame
    double spread_m = 0.0;     ///< standard deviation of the position, where that is estimated
  };

  /** @throws Error when there is no sample, or time goes back */
  explicit RecordedPath(std::vector<Sample> samples);

  /** Interpolated, the heading on the shorter way; the first or last pose outside the recorded
   * time. */
  mrpt::math::TPose2D poseAt(double time_s) const;
  /** Where the robot was `ahead_s` later, at most at the end of the recording. */
  mrpt::math::TPose2D goalAhead(double time_s, double ahead_s) const {
    return poseAt(time_s + ahead_s);
  }

  double duration_s() const { return samples_.back().time_s - samples_.front().time_s; }
  double length_m() const { return length_m_; }
  const std::vector<Sample>& samples() const { return samples_; }

 private:
  std::vector<Sample> samples_;
  double length_m_ = 0.0;
};

/** Reads the rest of a log and localises every frame: the first pass over a log. */
RecordedPath recordPath(RawlogReader& log, Localization& localization);

}  // namespace bslnav
