#include <bslnav/planning/FootprintCover.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

// A lattice this fine has a point within 0.403 cells of everywhere, and the outline one within half
// of it: whatever cell has its centre inside the footprint holds a point (0.403² + 0.285² < 0.5²).
constexpr double kSpacing = 0.57;
// The cover overlaps the inscribed circle by this much: for rounding to cells and the way of a
// step.
constexpr double kOverlap = 2.0;

/** The cover of a polygon with corners in cells. */
std::vector<TPoint2D> cover(const Footprint& footprint) {
  std::vector<TPoint2D> points;
  const auto& corners = footprint.polygon;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const TPoint2D a = corners[i], ab = corners[(i + 1) % corners.size()] - a;
    const int n = std::max(1, static_cast<int>(std::ceil(ab.norm() / kSpacing)));
    for (int k = 0; k < n; ++k) points.push_back(a + ab * (static_cast<double>(k) / n));
  }
  const double sure = footprint.inscribedRadius_m() - kOverlap;
  const int n = static_cast<int>(std::ceil(footprint.circumscribedRadius_m() / kSpacing));
  for (int iy = -n; iy <= n; ++iy)
    for (int ix = -n; ix <= n; ++ix) {
      const TPoint2D p{ix * kSpacing, iy * kSpacing};
      if (p.norm() > sure && footprint.contains(p)) points.push_back(p);
    }
  return points;
}

/** Lowest cost under the robot's centre when a point this far from it lies in a lethal cell. */
Cost lowestCentreCost(double distance, const InflationLayer& inflation) {
  const double cells = distance + M_SQRT2;  // both may be half a diagonal off their cells' centres
  return inflation.costAt(static_cast<int>(cells * cells));
}

}  // namespace

FootprintCover::FootprintCover(const Footprint& footprint, double resolution_m,
                               const InflationLayer& inflation) {
  if (footprint.isCircle()) return;
  Footprint inCells = footprint;
  for (auto& corner : inCells.polygon) corner *= 1.0 / resolution_m;
  auto points = cover(inCells);
  std::stable_sort(points.begin(), points.end(),
                   [](const TPoint2D& a, const TPoint2D& b) { return a.sqrNorm() > b.sqrNorm(); });
  reach_m_ = footprint.circumscribedRadius_m();
  for (const TPoint2D& p : points) {
    x_.push_back(static_cast<float>(p.x));
    y_.push_back(static_cast<float>(p.y));
    for (std::size_t cost = lowestCentreCost(p.norm(), inflation); cost < nearEnough_.size();
         ++cost)
      nearEnough_[cost] = x_.size();
  }
}

bool FootprintCover::touchesAny(const CostGrid& grid, float gx, float gy, float cosine, float sine,
                                std::size_t count) const {
  const auto width = static_cast<float>(grid.width()), height = static_cast<float>(grid.height());
  const Cost* cells = grid.row(0);
  const int stride = grid.width();
  for (std::size_t i = 0; i < count; ++i) {
    const float px = gx + cosine * x_[i] - sine * y_[i];
    const float py = gy + sine * x_[i] + cosine * y_[i];
    if (!(px >= 0.0f && py >= 0.0f && px < width && py < height)) continue;
    if (cells[static_cast<int>(py) * stride + static_cast<int>(px)] == kLethalCost) return true;
  }
  return false;
}

}  // namespace bslnav
