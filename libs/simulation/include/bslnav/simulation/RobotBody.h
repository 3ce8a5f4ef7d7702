#pragma once

#include <bslnav/simulation/WorldShape.h>
#include <mrpt/math/TPose2D.h>

#include <limits>
#include <vector>

namespace bslnav {

/** The robot's solid in its own frame: an outline seen from above, from the floor to a height. */
struct RobotOutline {
  std::vector<mrpt::math::TPoint2D> polygon{};  ///< any simple polygon; empty for a circle
  double radius_m = 0.25;                       ///< of the circle; not used with a polygon
  double height_m = 1.0;  ///< what begins higher than this passes over the robot
};

/** The robot's solid where it stands, and exactly how far it is from circles and solids. */
class RobotBody {
 public:
  /** @throws Error when the polygon has one or two corners, or a size is not above 0 */
  explicit RobotBody(const RobotOutline& outline);

  void moveTo(const mrpt::math::TPose2D& mapFromRobot);

  /** Clearance [m] to a circle in the map, 0 or less in contact. */
  double clearanceTo(const mrpt::math::TPoint2D& centre, double radius_m) const;
  /** Clearance [m] to a solid, 0 or less in contact; infinity when it is above the robot. */
  double clearanceTo(const WorldShape& shape) const;
  /** The smallest clearance to any of the solids; infinity when there are none. */
  double clearanceTo(const std::vector<WorldShape>& shapes) const;

 private:
  double distanceTo(const mrpt::math::TPoint2D& p) const;

  RobotOutline outline_;
  double reach_m_ = 0.0;  // radius of the circle around the outline
  mrpt::math::TPose2D pose_;
  std::vector<mrpt::math::TPoint2D> placed_;  // the polygon in the map frame
};

}  // namespace bslnav
