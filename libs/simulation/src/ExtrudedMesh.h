#pragma once

#include <bslnav/simulation/WorldShape.h>

#include <array>
#include <vector>

namespace bslnav {

/** A closed triangle mesh, in the layout that the ray caster shares. */
struct ExtrudedMesh {
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<unsigned, 3>> triangles;

  /** Adds a convex polygon extruded between two heights: sides, lower and upper face. */
  void add(const std::vector<mrpt::math::TPoint2D>& polygon, double zMin_m, double zMax_m);
  void add(const WorldShape& shape);
};

/** A regular polygon inside a circle, counterclockwise, at most `tolerance_m` away from it. */
std::vector<mrpt::math::TPoint2D> circlePolygon(const mrpt::math::TPoint2D& centre, double radius_m,
                                                double tolerance_m);

}  // namespace bslnav
