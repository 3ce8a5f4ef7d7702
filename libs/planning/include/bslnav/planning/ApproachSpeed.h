#pragma once

#include <bslnav/blindspot/Mover.h>
#include <bslnav/planning/Guard.h>
#include <bslnav/planning/MoverForecast.h>
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <vector>

namespace bslnav {

/** Who may cross the robot's path, map frame. */
struct Bystanders {
  const std::vector<mrpt::math::TPoint2D>& people;  ///< the nearest point of each who is seen
  const Movers& movers;                             ///< those of them who walk, or did just now
};

/** How fast to come up to where people who stand beside the path may cross it.
 *
 * Whoever sets out while the robot can no longer stop before that place, and is not through, meets
 * it there. A robot that comes at v, brakes and speeds up with a, and reaches its highest speed V
 * inside, is in that situation for v/2a + (V − v)/a − (V² − v²)/2aV and what does not depend on v:
 * least for v = V/2. They are taken to cross straight, be it the robot's heading or its path.
 * Whoever is farther from the robot than they walk while it drives through their way does not
 * matter.
 *
 * A courtesy of the planner; the guard's promise does not need it, and other motions (creeping,
 * making way) have their own speeds. Who walks is foreseen by MoverForecast. */
class ApproachSpeed {
 public:
  /** @param personSpeed_mps how fast people walk at most
   *  @param maxSpeed_mps the robot's highest speed */
  ApproachSpeed(const MoverParameters& parameters, const StoppingAbility& robot,
                double personSpeed_mps, double maxSpeed_mps)
      : parameters_(parameters),
        robot_(robot),
        personSpeed_mps_(personSpeed_mps),
        maxSpeed_mps_(maxSpeed_mps) {}

  /** From the highest speed down to `approachShare` of it, m/s.
   *  @param path global path, map frame */
  double speed_mps(const Bystanders& bystanders, const std::vector<mrpt::math::TPoint2D>& path,
                   const mrpt::math::TPose2D& mapFromRobot) const;

 private:
  MoverParameters parameters_;
  StoppingAbility robot_;
  double personSpeed_mps_, maxSpeed_mps_;
};

}  // namespace bslnav
