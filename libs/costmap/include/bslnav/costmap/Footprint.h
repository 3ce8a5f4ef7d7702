#pragma once

#include <bslnav/config/ConfigSection.h>
#include <mrpt/math/TPoint2D.h>

#include <vector>

namespace bslnav {

/** The robot's outline seen from above, in the robot frame (x forward, y left; metres). */
struct Footprint {
  double radius_m = 0.25;  ///< used when `polygon` is empty
  std::vector<mrpt::math::TPoint2D>
      polygon{};  ///< at least three corners around the origin, or empty for a circle

  void describe(ConfigSection& section);
  /** @throws Error when the polygon has one or two corners, or does not hold the robot's centre. */
  void check() const;

  bool isCircle() const { return polygon.empty(); }
  /** Radius of the largest circle around the origin inside the outline. */
  double inscribedRadius_m() const;
  /** Radius of the smallest circle around the origin that holds the outline. */
  double circumscribedRadius_m() const;
  /** Whether a point in the robot frame lies inside. */
  bool contains(const mrpt::math::TPoint2D& p) const;
};

}  // namespace bslnav
