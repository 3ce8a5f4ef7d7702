#include "WayRound.h"

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using Way = std::vector<TPoint2D>;

constexpr double kTurn_rad = M_PI / 9.0;  // between the corners around the circle

double bearing(const TPoint2D& from, const TPoint2D& to) {
  return std::atan2(to.y - from.y, to.x - from.x);
}

TPoint2D onCircle(const TPoint2D& centre, double radius_m, double bearing_rad) {
  return centre + TPoint2D(std::cos(bearing_rad), std::sin(bearing_rad)) * radius_m;
}

/** The path from where it first leaves the circle; empty where it stays inside. */
Way afterCircle(const Way& path, const TPoint2D& centre, double radius_m) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    const TPoint2D step = path[i] - path[i - 1], from = path[i - 1] - centre;
    const double along = (from.x * step.x + from.y * step.y) / step.sqrNorm();
    const TPoint2D foot = from - step * along;
    const double half = std::sqrt((radius_m * radius_m - foot.sqrNorm()) / step.sqrNorm());
    const double leaves = half - along;  // NaN: the line passes by, or has no length
    if (!(leaves >= 0.0 && leaves < 1.0)) continue;
    Way rest{path[i - 1] + step * leaves};
    rest.insert(rest.end(), path.begin() + static_cast<std::ptrdiff_t>(i), path.end());
    return rest;
  }
  return {};
}

bool isFree(const Way& way, const RobotOutline& walker, const std::vector<WorldShape>& solids) {
  constexpr double kApart_m = 0.05;
  RobotBody body(walker);
  for (std::size_t i = 1; i < way.size(); ++i) {
    const TPoint2D step = way[i] - way[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(step.norm() / kApart_m)));
    for (int part = 1; part <= parts; ++part) {
      const TPoint2D at = way[i - 1] + step * (static_cast<double>(part) / parts);
      body.moveTo({at.x, at.y, 0.0});
      if (body.clearanceTo(solids) <= 0.0) return false;
    }
  }
  return true;
}

/** From a point of the circle by `turn_rad` around it to another. */
Way alongCircle(const TPoint2D& centre, double radius_m, double from_rad, double turn_rad) {
  const int corners = std::max(1, static_cast<int>(std::ceil(std::abs(turn_rad) / kTurn_rad)));
  Way way;
  for (int i = 0; i <= corners; ++i)
    way.push_back(onCircle(centre, radius_m, from_rad + turn_rad * i / corners));
  return way;
}

}  // namespace

std::optional<Way> wayRound(const Way& path, const TPoint2D& centre, double radius_m,
                            const RobotOutline& walker, const std::vector<WorldShape>& solids) {
  const double cornerRadius_m = 1.02 * radius_m / std::cos(0.5 * kTurn_rad);  // chords stay outside
  const Way rest = afterCircle(path, centre, cornerRadius_m);
  if (rest.empty()) return std::nullopt;
  const double from_rad = bearing(centre, path.front());
  const double shorter_rad = mrpt::math::wrapToPi(bearing(centre, rest.front()) - from_rad);
  const double longer_rad = shorter_rad - std::copysign(2.0 * M_PI, shorter_rad);
  for (const double turn_rad : {shorter_rad, longer_rad}) {
    Way way = alongCircle(centre, cornerRadius_m, from_rad, turn_rad);
    way.insert(way.begin(), path.front());
    if (!isFree(way, walker, solids)) continue;
    way.insert(way.end(), rest.begin() + 1, rest.end());
    return way;
  }
  return std::nullopt;
}

}  // namespace bslnav
