#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <vector>

namespace bslnav {

/** c_pos: the distance from a point to the part of a polyline near the robot, for hundreds of
 * points a cycle. */
class PathDistance {
 public:
  /** Takes the part of the path between `behind_m` before and `ahead_m` after the point of it that
   * is nearest to the robot, with corners at least `spacing_m` apart. Does not allocate once it has
   * seen the longest part. */
  void setPath(const std::vector<mrpt::math::TPoint2D>& path, const mrpt::math::TPoint2D& robot,
               double behind_m, double ahead_m, double spacing_m);

  /** Distance to the nearest point of the part [m]; 0 without a path. */
  double operator()(const mrpt::math::TPoint2D& p) const;

 private:
  void addSegment(const mrpt::math::TPoint2D& a, const mrpt::math::TPoint2D& b);

  std::vector<float> ax_, ay_, bx_, by_,
      inverseLengthSquared_;  // segments from a along b, as arrays for the vector units
};

/** Index of the path point nearest to p, searched from `from` on; the path must not be empty. */
std::size_t nearestIndex(const std::vector<mrpt::math::TPoint2D>& path,
                         const mrpt::math::TPoint2D& p, std::size_t from = 0);

/** The point `ahead_m` farther along the path than its point nearest to p, or its end. */
mrpt::math::TPoint2D pointAhead(const std::vector<mrpt::math::TPoint2D>& path,
                                const mrpt::math::TPoint2D& p, double ahead_m);

}  // namespace bslnav
