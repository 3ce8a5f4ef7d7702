#pragma once

#include <bslnav/blindspot/Mover.h>
#include <bslnav/config/ConfigSection.h>
#include <bslnav/planning/Guard.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>

#include <vector>

namespace bslnav {

struct MoverParameters {
  double horizon_s = 4.0;      ///< people are taken to walk straight on for so long
  double radius_m = 0.35;      ///< around the middle of what is seen of a person
  double clearance_m = 0.4;    ///< who passes at this distance is not in anybody's way
  double approachShare = 0.5;  ///< of the highest speed, to where people who stand may cross

  void describe(ConfigSection& section);
};

/** Foresees whether the robot gets, or stays, in the way of people who are seen walking.
 *
 * That is no promise, people turn and stop as they like: the promise is the guard's. But a robot
 * that stands where somebody is about to walk is no help. */
class MoverForecast {
 public:
  MoverForecast(const MoverParameters& parameters, const StoppingAbility& robot,
                const GuardParameters& guard)
      : parameters_(parameters),
        robot_(robot),
        personSpeed_mps_(guard.personSpeed_mps),
        margin_m_(guard.margin_m) {}

  /** Takes over where the movers are now. */
  void begin(const mrpt::math::TPose2D& mapFromRobot, const Movers& movers);

  /** c_mov of a velocity (robot frame): 0 when all pass clear of the robot within the horizon, up
   * to 1 the nearer one comes, and 1 to 2 the more one would overlap it. Of two ways the better
   * one counts: the velocity is kept, or soon braked from; for who can still stop before somebody's
   * way need not stop yet. On both, the guard slows the robot down when somebody comes near. */
  double cost(const mrpt::math::TTwist2D& command) const;

 private:
  struct Relative {  // to the robot, its heading along x
    float x, y, vx, vy;
  };

  double worst(const mrpt::math::TTwist2D& command, double drivenFor_s) const;
  double admissibleSpeed_mps(double distance_m) const;

  MoverParameters parameters_;
  StoppingAbility robot_;
  double personSpeed_mps_, margin_m_;
  std::vector<Relative> movers_;
};

}  // namespace bslnav
