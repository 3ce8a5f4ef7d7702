#include "GlobalPlannerGrids.h"

#include <cmath>

namespace bslnav::test {

std::vector<std::int64_t> costsFrom(const CostGrid& grid, int x0, int y0,
                                    const GlobalPlannerParameters& parameters) {
  const auto passable = [&](int x, int y) {
    return grid.bounds().contains(x, y) &&
           (grid.at(x, y) < kInscribedCost ||
            (grid.at(x, y) == kUnknownCost && parameters.allowUnknown));
  };
  const auto step = [&](int x, int y, bool diagonal) {
    const double cost = std::min(grid.at(x, y), kHighestGradedCost);
    return std::llround((diagonal ? 577.0 : 408.0) * (1.0 + parameters.costWeight * cost / 252.0));
  };
  std::vector<std::int64_t> costs(static_cast<std::size_t>(grid.width() * grid.height()),
                                  kUnreached);
  const auto costOf = [&](int x, int y) -> std::int64_t& {
    return costs[static_cast<std::size_t>(y * grid.width() + x)];
  };
  if (passable(x0, y0)) costOf(x0, y0) = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (int y = 0; y < grid.height(); ++y)
      for (int x = 0; x < grid.width(); ++x)
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            if (costOf(x, y) == kUnreached || !passable(x + dx, y + dy)) continue;
            if (!passable(x + dx, y) || !passable(x, y + dy)) continue;
            const std::int64_t cost =
                costOf(x, y) + (dx || dy ? step(x + dx, y + dy, dx && dy) : 0);
            std::int64_t& there = costOf(x + dx, y + dy);
            if (there != kUnreached && there <= cost) continue;
            there = cost;
            changed = true;
          }
  }
  return costs;
}

}  // namespace bslnav::test
