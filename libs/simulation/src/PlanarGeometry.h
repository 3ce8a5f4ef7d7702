#pragma once

#include <mrpt/math/TPoint2D.h>

#include <vector>

namespace bslnav {

/** Distance [m] from a point to the outline of a simple polygon; negative inside. */
double distanceToPolygon(const mrpt::math::TPoint2D& p,
                         const std::vector<mrpt::math::TPoint2D>& polygon);

/** Distance [m] between two simple polygons; 0 when they touch or overlap. */
double distanceBetweenPolygons(const std::vector<mrpt::math::TPoint2D>& a,
                               const std::vector<mrpt::math::TPoint2D>& b);

}  // namespace bslnav
