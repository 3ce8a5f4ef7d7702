#pragma once

#include <bslnav/simulation/WorldParameters.h>

#include <string>
#include <vector>

namespace bslnav {

/** One convex solid: a polygon or a circle in the map frame, extruded between two heights. */
struct WorldShape {
  std::string section;                        ///< where it is configured, for example "wall:left"
  std::vector<mrpt::math::TPoint2D> polygon;  ///< convex, counterclockwise; empty for a cylinder
  mrpt::math::TPoint2D centre;
  double radius_m = 0.0;  ///< of the cylinder, or of the circle around the polygon
  double zMin_m = 0.0, zMax_m = 0.0;
  bool mapped = true;

  bool isCylinder() const { return polygon.empty(); }
};

/** The solids of a world, one for each wall segment, box and cylinder.
 *
 * A wall segment that another follows is lengthened by half the thickness, which closes the corner.
 * @throws Error as WorldParameters::check() does */
std::vector<WorldShape> worldShapes(const WorldParameters& world);

/** An axis-aligned rectangle in the map frame [m]. */
struct WorldBounds {
  mrpt::math::TPoint2D lower, upper;
};

/** The smallest rectangle around all solids and pedestrians' paths; the origin without any. */
WorldBounds worldBounds(const WorldParameters& world);

}  // namespace bslnav
