#pragma once

#include <bslnav/costmap/CostGrid.h>
#include <mrpt/math/TPoint2D.h>

namespace bslnav {

/** Distance from a point to the centre of the nearest lethal cell, at most `limit_m`. */
double clearance(const CostGrid& costs, const mrpt::math::TPoint2D& p, double limit_m);

}  // namespace bslnav
