#include <bslnav/config/Config.h>
#include <bslnav/simulation/StaticMap.h>
#include <bslnav/simulation/WorldShape.h>

#include <algorithm>
#include <cmath>

#include "PlanarGeometry.h"

namespace bslnav {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPoint2D;

constexpr float kFree = 1.0f, kOccupied = 0.0f;
constexpr double kRounding = 1e-6;  // of a quotient that should be a whole number
// A solid that only touches a cell's edge does not fill it; MRPT keeps the grid's edges in float.
constexpr double kTouch_m = 1e-5;

bool overlaps(const WorldShape& shape, const TPoint2D& centre, double halfCell_m) {
  const double h = halfCell_m - kTouch_m;
  if (shape.isCylinder()) {
    const double dx = std::max(0.0, std::abs(shape.centre.x - centre.x) - h);
    const double dy = std::max(0.0, std::abs(shape.centre.y - centre.y) - h);
    return std::hypot(dx, dy) < shape.radius_m;
  }
  const std::vector<TPoint2D> cell{{centre.x - h, centre.y - h},
                                   {centre.x + h, centre.y - h},
                                   {centre.x + h, centre.y + h},
                                   {centre.x - h, centre.y + h}};
  return distanceBetweenPolygons(shape.polygon, cell) <= 0.0;
}

void draw(const WorldShape& shape, double resolution_m, COccupancyGridMap2D& map) {
  const double r = shape.radius_m + resolution_m;
  const auto& c = shape.centre;
  const auto column = [&map](double x) { return map.x2idx(static_cast<float>(x)); };
  const auto row = [&map](double y) { return map.y2idx(static_cast<float>(y)); };
  for (int y = row(c.y - r); y <= row(c.y + r); ++y)
    for (int x = column(c.x - r); x <= column(c.x + r); ++x) {
      const TPoint2D centre(map.getXMin() + (x + 0.5) * resolution_m,
                            map.getYMin() + (y + 0.5) * resolution_m);
      if (overlaps(shape, centre, resolution_m / 2)) map.setCell(x, y, kOccupied);
    }
}

}  // namespace

std::shared_ptr<COccupancyGridMap2D> staticMap(const WorldParameters& world, double resolution_m,
                                               double laserHeight_m, double margin_m) {
  if (!(resolution_m > 0.0)) Config::refuse("static map", "resolution_m", "a number above 0");
  if (!(margin_m >= 0.0)) Config::refuse("static map", "margin_m", "a number of at least 0");
  const auto bounds = worldBounds(world);
  // Edges at multiples of the resolution, as grids elsewhere have; at least one cell.
  const auto below = [&](double value) {
    return std::floor((value - margin_m) / resolution_m + kRounding);
  };
  const auto above = [&](double value, double lower) {
    return std::max(std::ceil((value + margin_m) / resolution_m - kRounding), below(lower) + 1.0);
  };
  const auto metres = [&](double cells) { return static_cast<float>(cells * resolution_m); };
  auto map = COccupancyGridMap2D::Create();
  map->setSize(metres(below(bounds.lower.x)), metres(above(bounds.upper.x, bounds.lower.x)),
               metres(below(bounds.lower.y)), metres(above(bounds.upper.y, bounds.lower.y)),
               static_cast<float>(resolution_m), kFree);
  for (const auto& shape : worldShapes(world))
    if (shape.mapped && shape.zMin_m <= laserHeight_m && laserHeight_m <= shape.zMax_m)
      draw(shape, resolution_m, *map);
  return map;
}

}  // namespace bslnav
