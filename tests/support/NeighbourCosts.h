#pragma once

#include <bslnav/costmap/CostGrid.h>

#include <algorithm>

namespace bslnav::test {

/** A grid in which every cell has the cost that `choose` prefers among it and its eight neighbours.
 */
template <typename Choose>
CostGrid neighbourCost(const CostGrid& grid, Choose choose) {
  CostGrid result = grid;
  for (int y = 0; y < grid.height(); ++y)
    for (int x = 0; x < grid.width(); ++x)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if (grid.bounds().contains(x + dx, y + dy))
            result.at(x, y) = choose(result.at(x, y), grid.at(x + dx, y + dy));
  return result;
}
inline CostGrid lowestNeighbour(const CostGrid& grid) {
  return neighbourCost(grid, [](Cost a, Cost b) { return std::min(a, b); });
}
inline CostGrid highestNeighbour(const CostGrid& grid) {
  return neighbourCost(grid, [](Cost a, Cost b) { return std::max(a, b); });
}

}  // namespace bslnav::test
