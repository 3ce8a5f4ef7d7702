#pragma once

#include <bslnav/costmap/CostGrid.h>
#include <bslnav/planning/GlobalPlanner.h>

#include <cstdint>
#include <string>
#include <vector>

namespace bslnav::test {

/** A grid of 0.5 m cells with the corner at (−3, 2), drawn row by row from the top.
 *  '.' free, '1'..'9' graded 28·digit, 'i' inscribed, '#' lethal, '?' unknown. */
inline CostGrid drawn(const std::vector<std::string>& rows) {
  CostGrid grid(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), 0.5, -3.0, 2.0);
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x) {
      const char c =
          rows[rows.size() - 1 - static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      grid.at(x, y) = c == '#'   ? kLethalCost
                      : c == 'i' ? kInscribedCost
                      : c == '?' ? kUnknownCost
                      : c == '.' ? kFreeCost
                                 : static_cast<Cost>(28 * (c - '0'));
    }
  return grid;
}

/** Centre of a cell in the map frame. */
inline mrpt::math::TPoint2D centre(const CostGrid& grid, int x, int y) {
  return {grid.idx2x(x), grid.idx2y(y)};
}

inline constexpr std::int64_t kUnreached = -1;

/** Plain Dijkstra by repeated relaxation until nothing changes: cost from (x0, y0) to every cell,
 * in 1/408 cells. */
std::vector<std::int64_t> costsFrom(const CostGrid& grid, int x0, int y0,
                                    const GlobalPlannerParameters& parameters);

}  // namespace bslnav::test
