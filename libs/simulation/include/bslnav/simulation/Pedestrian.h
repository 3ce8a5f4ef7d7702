#pragma once

#include <bslnav/simulation/WorldParameters.h>

#include <limits>

namespace bslnav {

/** One person's walk: waits for trigger and delay, walks the path once, stands at its end. */
class Pedestrian {
 public:
  explicit Pedestrian(const PedestrianParameters& parameters);

  /** Tells that the robot's centre moved straight between two points of the map in this interval.
   *
   *  The first crossing of the trigger line, at its exact time, starts the walk. */
  void observeRobot(const mrpt::math::TPoint2D& from, double from_s, const mrpt::math::TPoint2D& to,
                    double to_s);

  /** Exact position in the map at a time, given the trigger known so far. */
  mrpt::math::TPoint2D position(double time_s) const;
  /** Whether the walk has begun; stays true at its end. */
  bool started(double time_s) const { return time_s >= start_s_; }
  /** The walking speed while walking, else 0. */
  double speed_mps(double time_s) const;
  const PedestrianParameters& parameters() const { return parameters_; }

 private:
  PedestrianParameters parameters_;
  double pathLength_m_ = 0.0;
  double start_s_ = std::numeric_limits<double>::infinity();
};

}  // namespace bslnav
