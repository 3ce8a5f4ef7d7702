#pragma once

#include <bslnav/blindspot/Mover.h>
#include <bslnav/config/ConfigSection.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>

#include <vector>

namespace bslnav {

struct MoverParameters {
  double horizon_s = 3.0;    ///< people are taken to walk straight on for so long
  double radius_m = 0.35;    ///< around the middle of what is seen of a person
  double clearance_m = 0.4;  ///< who passes at this distance is not in anybody's way

  void describe(ConfigSection& section);
};

/** Foresees whether the robot gets, or stays, in the way of people who are seen walking.
 *
 * That is no promise, people turn and stop as they like: the promise is the guard's. But a robot
 * that stands where somebody is about to walk is no help. */
class MoverForecast {
 public:
  /** @param robotRadius_m of the circle that holds the robot's outline */
  MoverForecast(const MoverParameters& parameters, double robotRadius_m)
      : parameters_(parameters), robotRadius_m_(robotRadius_m) {}

  /** Takes over where the movers are now. */
  void begin(const mrpt::math::TPose2D& mapFromRobot, const Movers& movers);
  bool empty() const { return movers_.empty(); }

  /** c_mov of a velocity (robot frame) that is kept for the horizon: 0 when all pass clear of the
   * robot, up to 1 the nearer one comes, and 1 to 2 the sooner one meets it. */
  double cost(const mrpt::math::TTwist2D& command) const;

 private:
  struct Relative {  // to the robot, its heading along x
    float x, y, vx, vy;
  };

  MoverParameters parameters_;
  double robotRadius_m_;
  std::vector<Relative> movers_;
};

}  // namespace bslnav
