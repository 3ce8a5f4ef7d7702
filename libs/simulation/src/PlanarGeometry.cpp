#include "PlanarGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using Polygon = std::vector<TPoint2D>;

double cross(const TPoint2D& a, const TPoint2D& b) { return a.x * b.y - a.y * b.x; }

double squaredDistanceToSegment(const TPoint2D& p, const TPoint2D& a, const TPoint2D& b) {
  const TPoint2D ab = b - a, ap = p - a;
  const double length2 = ab.sqrNorm();
  const double t =
      length2 > 0.0 ? std::clamp((ap.x * ab.x + ap.y * ab.y) / length2, 0.0, 1.0) : 0.0;
  return (ap - ab * t).sqrNorm();
}

double squaredDistanceToOutline(const TPoint2D& p, const Polygon& polygon) {
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
    nearest = std::min(nearest, squaredDistanceToSegment(p, polygon[j], polygon[i]));
  return nearest;
}

bool inside(const TPoint2D& p, const Polygon& polygon) {
  bool result = false;  // even-odd rule
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const TPoint2D &a = polygon[i], &b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
      result = !result;
  }
  return result;
}

/** Whether two segments cross at a point inside both; touching ends are found by the distances. */
bool cross(const TPoint2D& a, const TPoint2D& b, const TPoint2D& c, const TPoint2D& d) {
  const double c1 = cross(b - a, c - a), d1 = cross(b - a, d - a);
  const double a1 = cross(d - c, a - c), b1 = cross(d - c, b - c);
  return c1 * d1 < 0.0 && a1 * b1 < 0.0;
}

bool outlinesCross(const Polygon& a, const Polygon& b) {
  for (std::size_t i = 0, j = a.size() - 1; i < a.size(); j = i++)
    for (std::size_t k = 0, l = b.size() - 1; k < b.size(); l = k++)
      if (cross(a[j], a[i], b[l], b[k])) return true;
  return false;
}

}  // namespace

double distanceToPolygon(const TPoint2D& p, const Polygon& polygon) {
  const double distance = std::sqrt(squaredDistanceToOutline(p, polygon));
  return inside(p, polygon) ? -distance : distance;
}

double distanceBetweenPolygons(const Polygon& a, const Polygon& b) {
  // Outlines that do not cross are nearest at a corner, unless one polygon holds the other.
  if (outlinesCross(a, b) || inside(a.front(), b) || inside(b.front(), a)) return 0.0;
  double nearest = std::numeric_limits<double>::max();
  for (const auto& p : a) nearest = std::min(nearest, squaredDistanceToOutline(p, b));
  for (const auto& p : b) nearest = std::min(nearest, squaredDistanceToOutline(p, a));
  return std::sqrt(nearest);
}

}  // namespace bslnav
