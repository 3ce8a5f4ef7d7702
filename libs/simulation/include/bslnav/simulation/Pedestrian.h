#pragma once

#include <bslnav/simulation/WorldShape.h>

#include <limits>

namespace bslnav {

/** One person's walk: waits for trigger and delay, walks the path once, stands at its end; in
 * between one pause, waits for the robot and walks round it, where the parameters say so. */
class Pedestrian {
 public:
  explicit Pedestrian(const PedestrianParameters& parameters);

  /** Tells that the robot's centre moved straight between two points of the map in this interval.
   *
   *  The first crossing of the trigger line, at its exact time, starts the walk. Who yields stands
   *  still in this interval when walking on would lead too near to `to`. */
  void observeRobot(const mrpt::math::TPoint2D& from, double from_s, const mrpt::math::TPoint2D& to,
                    double to_s);

  /** Who has waited long enough for the robot walks round it from `time_s`, if a side is free; else
   *  waits as long again.
   *  @param robot its centre, map frame @param solids that must not be walked through */
  void walkRound(const mrpt::math::TPoint2D& robot, double time_s,
                 const std::vector<WorldShape>& solids);

  /** Exact position in the map at a time, given the trigger and the waiting known so far. */
  mrpt::math::TPoint2D position(double time_s) const;
  /** Whether the walk has begun; stays true at its end. */
  bool started(double time_s) const { return time_s >= start_s_; }
  /** The walking speed while walking, else 0. */
  double speed_mps(double time_s) const;
  const PedestrianParameters& parameters() const { return parameters_; }

 private:
  double walked_m(double time_s) const;
  mrpt::math::TPoint2D pointAfter(double walked_m) const;
  std::size_t cornerAfter(double walked_m) const;  // index of the path's next corner
  void measurePath();
  void yieldTo(const mrpt::math::TPoint2D& robot, double from_s, double to_s);

  PedestrianParameters parameters_;
  double pathLength_m_ = 0.0;
  double waited_s_ = 0.0, waitsFor_s_ = 0.0;  // for the robot: in all, and now
  bool waits_ = false;                        // for the robot, now
  double start_s_ = std::numeric_limits<double>::infinity();
};

}  // namespace bslnav
