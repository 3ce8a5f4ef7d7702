#include <bslnav/config/Config.h>
#include <bslnav/costmap/StaticLayer.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace bslnav {
namespace {

constexpr double kRounding = 1e-3;  // of a map cell: MRPT keeps resolution and limits as floats

/** The cells of one lattice that an interval of another one overlaps, half-open. */
struct Overlap {
  int first, last;
  Overlap(double from_m, double to_m, double origin_m, double resolution_m)
      : first(static_cast<int>(std::floor((from_m - origin_m) / resolution_m + kRounding))),
        last(static_cast<int>(std::ceil((to_m - origin_m) / resolution_m - kRounding))) {}
};

int badness(Cost cost) { return cost == kLethalCost ? 2 : cost == kUnknownCost ? 1 : 0; }

CostGrid thresholded(const mrpt::maps::COccupancyGridMap2D& map,
                     const StaticParameters& parameters) {
  CostGrid result(static_cast<int>(map.getSizeX()), static_cast<int>(map.getSizeY()), 1.0, 0.0,
                  0.0);
  for (int y = 0; y < result.height(); ++y)
    for (int x = 0; x < result.width(); ++x) {
      const double occupied = 1.0 - static_cast<double>(map.getCell(x, y));
      result.at(x, y) = occupied >= parameters.occupiedThreshold ? kLethalCost
                        : occupied <= parameters.freeThreshold   ? kFreeCost
                                                                 : kUnknownCost;
    }
  return result;
}

Cost worst(const CostGrid& cells, const Overlap& xs, const Overlap& ys) {
  const CellWindow wanted{xs.first, ys.first, xs.last, ys.last};
  const CellWindow inside = wanted.intersected(cells.bounds());
  Cost result = inside == wanted ? kFreeCost : kUnknownCost;
  for (int y = inside.y0; y < inside.y1; ++y)
    for (int x = inside.x0; x < inside.x1; ++x)
      if (badness(cells.at(x, y)) > badness(result)) result = cells.at(x, y);
  return result;
}

int originCell(double minimum_m, double resolution_m) {
  return static_cast<int>(std::lround(minimum_m / resolution_m));
}

}  // namespace

void StaticParameters::describe(ConfigSection& section) {
  section.number("map_occupied_threshold", occupiedThreshold, {0.0, 1.0}, "",
                 "map cells that are occupied with at least this probability are lethal");
  section.number("map_free_threshold", freeThreshold, {0.0, 1.0}, "",
                 "map cells that are occupied with at most this probability are free; unknown "
                 "between the two");
}

void StaticParameters::check() const {
  if (freeThreshold >= occupiedThreshold)
    Config::refuse("costmap", "map_free_threshold", "a value below map_occupied_threshold");
}

StaticLayer::StaticLayer(const mrpt::maps::COccupancyGridMap2D& map, double resolution_m,
                         const StaticParameters& parameters) {
  const double cell = map.getResolution(), x0 = map.getXMin(), y0 = map.getYMin();
  const double tolerance = kRounding * cell / resolution_m;
  const auto lowest = [&](double from_m) {
    return static_cast<int>(std::floor(from_m / resolution_m + tolerance));
  };
  const auto highest = [&](double to_m) {
    return static_cast<int>(std::ceil(to_m / resolution_m - tolerance));
  };
  const int left = lowest(x0), bottom = lowest(y0);
  grid_ = CostGrid(highest(x0 + cell * map.getSizeX()) - left,
                   highest(y0 + cell * map.getSizeY()) - bottom, resolution_m, left * resolution_m,
                   bottom * resolution_m, kUnknownCost);

  const CostGrid cells = thresholded(map, parameters);
  std::vector<Overlap> columns;
  columns.reserve(static_cast<std::size_t>(grid_.width()));
  for (int x = 0; x < grid_.width(); ++x)
    columns.emplace_back((left + x) * resolution_m, (left + x + 1) * resolution_m, x0, cell);
  for (int y = 0; y < grid_.height(); ++y) {
    const Overlap rows((bottom + y) * resolution_m, (bottom + y + 1) * resolution_m, y0, cell);
    for (int x = 0; x < grid_.width(); ++x)
      grid_.at(x, y) = worst(cells, columns[static_cast<std::size_t>(x)], rows);
  }
}

void StaticLayer::copyTo(CostGrid& out, const CellWindow& window) const {
  const double resolution_m = grid_.getResolution();
  const int dx =
      originCell(out.getXMin(), resolution_m) - originCell(grid_.getXMin(), resolution_m);
  const int dy =
      originCell(out.getYMin(), resolution_m) - originCell(grid_.getYMin(), resolution_m);
  const CellWindow target = window.intersected(out.bounds());
  const CellWindow known = target.intersected(grid_.bounds().shifted(-dx, -dy));
  for (int y = target.y0; y < target.y1; ++y) {
    Cost* row = out.row(y);
    if (!known.contains(known.x0, y)) {
      std::fill(row + target.x0, row + std::max(target.x0, target.x1), kUnknownCost);
      continue;
    }
    std::fill(row + target.x0, row + known.x0, kUnknownCost);
    std::memcpy(row + known.x0, grid_.row(y + dy) + known.x0 + dx,
                static_cast<std::size_t>(known.width()));
    std::fill(row + known.x1, row + target.x1, kUnknownCost);
  }
}

}  // namespace bslnav
