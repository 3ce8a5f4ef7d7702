#include "ExtrudedMesh.h"

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

constexpr double kRoundness_m = 0.0005;

std::array<float, 3> vertex(double x, double y, double z) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

}  // namespace

void ExtrudedMesh::add(const std::vector<TPoint2D>& polygon, double zMin_m, double zMax_m) {
  const auto first = static_cast<unsigned>(vertices.size());
  const auto n = static_cast<unsigned>(polygon.size());
  for (const auto& corner : polygon) {
    vertices.push_back(vertex(corner.x, corner.y, zMin_m));
    vertices.push_back(vertex(corner.x, corner.y, zMax_m));
  }
  const auto lower = [first, n](unsigned i) { return first + 2 * (i % n); };
  const auto upper = [lower](unsigned i) { return lower(i) + 1; };
  for (unsigned i = 0; i < n; ++i) {
    triangles.push_back({lower(i), lower(i + 1), upper(i + 1)});
    triangles.push_back({lower(i), upper(i + 1), upper(i)});
  }
  for (unsigned i = 1; i + 1 < n; ++i) {
    if (zMin_m > 0.0) triangles.push_back({lower(0), lower(i + 1), lower(i)});
    triangles.push_back({upper(0), upper(i), upper(i + 1)});
  }
}

void ExtrudedMesh::add(const WorldShape& shape) {
  add(shape.isCylinder() ? circlePolygon(shape.centre, shape.radius_m, kRoundness_m)
                         : shape.polygon,
      shape.zMin_m, shape.zMax_m);
}

std::vector<TPoint2D> circlePolygon(const TPoint2D& centre, double radius_m, double tolerance_m) {
  // The middle of a side lies r·(1 − cos(π/n)) inside the circle.
  const double halfSide_rad = std::acos(std::max(0.0, 1.0 - tolerance_m / radius_m));
  const int n = std::max(32, static_cast<int>(std::ceil(M_PI / halfSide_rad)));
  std::vector<TPoint2D> polygon;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * M_PI * i / n;
    polygon.emplace_back(centre.x + radius_m * std::cos(angle),
                         centre.y + radius_m * std::sin(angle));
  }
  return polygon;
}

}  // namespace bslnav
