#include <bslnav/config/Config.h>
#include <bslnav/costmap/Footprint.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

double distanceToSegment(const TPoint2D& p, const TPoint2D& a, const TPoint2D& b) {
  const TPoint2D ab = b - a, ap = p - a;
  const double lengthSquared = ab.x * ab.x + ab.y * ab.y;
  const double t =
      lengthSquared > 0 ? std::clamp((ap.x * ab.x + ap.y * ab.y) / lengthSquared, 0.0, 1.0) : 0.0;
  return std::hypot(ap.x - t * ab.x, ap.y - t * ab.y);
}

}  // namespace

void Footprint::describe(ConfigSection& section) {
  section.number("radius_m", radius_m, {0.01, 10.0}, "m",
                 "radius of a circular robot; not used with a polygon");
  section.points("polygon_m", polygon, 0,
                 "outline in the robot frame, at least three corners; empty for a circle");
}

void Footprint::check() const {
  if (isCircle()) return;
  if (polygon.size() < 3 || !contains({0.0, 0.0}))
    Config::refuse("footprint", "polygon_m",
                   "at least three corners around the robot's centre (0, 0)");
}

double Footprint::inscribedRadius_m() const {
  if (isCircle()) return radius_m;
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    nearest =
        std::min(nearest, distanceToSegment({0, 0}, polygon[i], polygon[(i + 1) % polygon.size()]));
  return nearest;
}

double Footprint::circumscribedRadius_m() const {
  if (isCircle()) return radius_m;
  double farthest = 0.0;
  for (const auto& corner : polygon) farthest = std::max(farthest, corner.norm());
  return farthest;
}

bool Footprint::contains(const TPoint2D& p) const {
  if (isCircle()) return p.norm() <= radius_m;
  bool inside = false;  // even-odd rule
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const TPoint2D &a = polygon[i], &b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
      inside = !inside;
  }
  return inside;
}

}  // namespace bslnav
