#include <bslnav/navigation/Clearance.h>

#include <algorithm>
#include <cmath>

namespace bslnav {

double clearance(const CostGrid& costs, const mrpt::math::TPoint2D& p, double limit_m) {
  const int reach = static_cast<int>(std::ceil(limit_m / costs.getResolution()));
  const int x = costs.cellX(p.x), y = costs.cellY(p.y);
  const CellWindow near = CellWindow{x, y, x + 1, y + 1}.grown(reach).intersected(costs.bounds());
  double nearest = limit_m;
  for (int cy = near.y0; cy < near.y1; ++cy)
    for (int cx = near.x0; cx < near.x1; ++cx)
      if (costs.at(cx, cy) == kLethalCost)
        nearest = std::min(nearest, std::hypot(costs.idx2x(cx) - p.x, costs.idx2y(cy) - p.y));
  return nearest;
}

}  // namespace bslnav
