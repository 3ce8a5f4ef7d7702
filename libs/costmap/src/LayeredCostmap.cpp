#include <bslnav/config/Config.h>
#include <bslnav/config/Error.h>
#include <bslnav/costmap/LayeredCostmap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string>

namespace bslnav {
namespace {

constexpr double kMostCells = 16384.0;  // a side

CostGrid initialGrid(const CostmapParameters& parameters, const std::optional<StaticLayer>& map,
                     Extent extent) {
  if (extent == Extent::WholeMap) {
    if (!map)
      throw Error("costmap", "a cost map of the whole map was asked for, but there is no map");
    return map->grid();
  }
  const double r = parameters.resolution_m;
  const int width = static_cast<int>(std::lround(parameters.width_m / r));
  const int height = static_cast<int>(std::lround(parameters.height_m / r));
  const int left = width / 2, below = height / 2;
  CostGrid grid(width, height, r, -left * r, -below * r, kFreeCost);
  if (map) map->copyTo(grid, grid.bounds());
  return grid;
}

std::optional<StaticLayer> staticLayer(const CostmapParameters& parameters,
                                       const Footprint& footprint,
                                       const mrpt::maps::COccupancyGridMap2D* map) {
  parameters.check();
  footprint.check();
  if (!map) return std::nullopt;
  return StaticLayer(*map, parameters.resolution_m, parameters.map);
}

void copy(const CostGrid& from, const CellWindow& window, CostGrid& to) {
  for (int y = window.y0; y < window.y1; ++y)
    std::memcpy(to.row(y) + window.x0, from.row(y) + window.x0,
                static_cast<std::size_t>(window.width()));
}

/** Two layers in one row. Both hold 0, 254 or 255 only, so that the lower one is right where
 * neither is lethal. `merged` may be one of them. */
void mergeRow(const Cost* background, const Cost* obstacles, Cost* merged, int count) {
  for (int x = 0; x < count; ++x) {
    const Cost lower = background[x] < obstacles[x] ? background[x] : obstacles[x];
    const bool lethal = (background[x] == kLethalCost) | (obstacles[x] == kLethalCost);
    merged[x] = lethal ? kLethalCost : lower;
  }
}

/** Copies a row; returns the cells that this changed, half-open, as the window's x0 and x1 (row
 * `y`). */
CellWindow replaceRow(const std::vector<Cost>& from, const CellWindow& window, int y, Cost* to) {
  const auto first = from.begin(), last = first + window.width();
  const auto firstChanged = std::mismatch(first, last, to + window.x0).first;
  if (firstChanged == last) return {};
  const auto end = std::make_reverse_iterator(last),
             start = std::make_reverse_iterator(firstChanged);
  const auto lastChanged =
      std::mismatch(end, start, std::make_reverse_iterator(to + window.x1)).first.base();
  std::copy(firstChanged, lastChanged, to + window.x0 + (firstChanged - first));
  return {window.x0 + static_cast<int>(firstChanged - first), y,
          window.x0 + static_cast<int>(lastChanged - first), y + 1};
}

}  // namespace

void CostmapParameters::describe(ConfigSection& section) {
  section.number("resolution_m", resolution_m, {0.005, 1.0}, "m", "side of a cell");
  section.number("width_m", width_m, {0.5, 1000.0}, "m",
                 "size along x of the cost map that moves with the robot");
  section.number("height_m", height_m, {0.5, 1000.0}, "m",
                 "size along y of the cost map that moves with the robot");
  map.describe(section);
  obstacles.describe(section);
  inflation.describe(section);
}

void CostmapParameters::check() const {
  map.check();
  const std::string expected =
      "1 to " + std::to_string(static_cast<int>(kMostCells)) + " cells of resolution_m";
  const auto fits = [this](double size_m) {
    return size_m >= resolution_m && size_m <= kMostCells * resolution_m;
  };
  if (!fits(width_m)) Config::refuse("costmap", "width_m", expected);
  if (!fits(height_m)) Config::refuse("costmap", "height_m", expected);
}

LayeredCostmap::LayeredCostmap(const CostmapParameters& parameters, const Footprint& footprint,
                               const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map,
                               Extent extent)
    : extent_(extent),
      inscribedRadius_m_(footprint.inscribedRadius_m()),
      static_(staticLayer(parameters, footprint, map.get())),
      background_(initialGrid(parameters, static_, extent)),
      obstacles_(parameters.obstacles, footprint, background_),
      depthObstacles_(parameters.obstacles, footprint, background_),
      merged_(background_),
      mergedRow_(background_.getSizeX()),
      inflation_(parameters.inflation, inscribedRadius_m_, parameters.resolution_m),
      inflated_(background_),
      costs_(background_) {
  inflate(costs_.bounds());
}

void LayeredCostmap::update(const mrpt::math::TPose2D& mapFromRobot,
                            const std::vector<PlanarScan>& scans,
                            const std::vector<DangerZone>& zones,
                            const std::vector<PlanarScan>& depthScans) {
  const CellWindow moved = recentre(mapFromRobot);
  CellWindow visited = obstacles_.update(mapFromRobot, scans);
  if (usesDepth_ || !depthScans.empty()) {
    usesDepth_ = true;
    visited = visited.united(depthObstacles_.update(mapFromRobot, depthScans, &obstacles_.grid()));
  }
  const CellWindow changed = merge(visited.united(moved));
  copy(inflated_, zones_, costs_);
  inflate(changed.united(moved));
  zones_ = addDangerZones(zones, costs_);
}

/** Brings the robot to the middle; returns the window to recompute: everything, if the grid moved.
 */
CellWindow LayeredCostmap::recentre(const mrpt::math::TPose2D& mapFromRobot) {
  if (extent_ == Extent::WholeMap) return {};
  const CellWindow all = costs_.bounds();
  const int dx = costs_.cellX(mapFromRobot.x) - all.width() / 2,
            dy = costs_.cellY(mapFromRobot.y) - all.height() / 2;
  if (dx == 0 && dy == 0) return {};
  for (CostGrid* grid : {&background_, &merged_, &inflated_, &costs_})
    grid->shift(dx, dy, kFreeCost);
  obstacles_.shift(dx, dy);
  depthObstacles_.shift(dx, dy);
  if (static_) static_->copyTo(background_, all);
  return all;
}

/** Merges static and obstacle layer in a window; returns the window of what changed. */
CellWindow LayeredCostmap::merge(const CellWindow& window) {
  CellWindow changed;
  for (int y = window.y0; y < window.y1; ++y) {
    mergeRow(background_.row(y) + window.x0, obstacles_.grid().row(y) + window.x0,
             mergedRow_.data(), window.width());
    if (usesDepth_)
      mergeRow(mergedRow_.data(), depthObstacles_.grid().row(y) + window.x0, mergedRow_.data(),
               window.width());
    if (std::memcmp(mergedRow_.data(), merged_.row(y) + window.x0,
                    static_cast<std::size_t>(window.width())) != 0)
      changed = changed.united(replaceRow(mergedRow_, window, y, merged_.row(y)));
  }
  return changed;
}

void LayeredCostmap::inflate(const CellWindow& changed) {
  const CellWindow window = changed.grown(inflation_.reach()).intersected(costs_.bounds());
  inflation_.apply(merged_, window, inflated_);
  copy(inflated_, window, costs_);
}

}  // namespace bslnav
