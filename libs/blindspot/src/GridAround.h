#pragma once

#include <bslnav/costmap/CostGrid.h>
#include <mrpt/math/TPoint2D.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace bslnav {

inline constexpr Cost kYes = 255, kNo = 0;

/** An odd number of cells that reach as far to each side of the robot, all kYes. */
inline CostGrid gridAround(double reach_m, double resolution_m) {
  const int half = static_cast<int>(std::ceil(reach_m / resolution_m));
  return CostGrid(2 * half + 1, 2 * half + 1, resolution_m, -half * resolution_m,
                  -half * resolution_m, kYes);
}

/** Moves a grid over the map so that a place is in its middle cell; what is new is kYes.
 * @return whether it moved */
inline bool recentre(CostGrid& grid, double x_m, double y_m) {
  const int half = grid.width() / 2;
  const int dx = grid.cellX(x_m) - half, dy = grid.cellY(y_m) - half;
  if (dx == 0 && dy == 0) return false;
  grid.shift(dx, dy, kYes);
  return true;
}

inline void fill(CostGrid& grid, Cost value) {
  std::fill(grid.row(0), grid.row(0) + std::ptrdiff_t{grid.width()} * grid.height(), value);
}

/** The square around a disc, as far as the grid reaches. */
inline CellWindow cellsAround(const CostGrid& grid, const mrpt::math::TPoint2D& centre,
                              double radius_m) {
  const int reach = 1 + static_cast<int>(radius_m / grid.getResolution());
  const int x = grid.cellX(centre.x), y = grid.cellY(centre.y);
  return CellWindow{x, y, x + 1, y + 1}.grown(reach).intersected(grid.bounds());
}

}  // namespace bslnav
