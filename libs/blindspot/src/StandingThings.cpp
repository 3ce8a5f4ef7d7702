#include <bslnav/blindspot/StandingThings.h>

#include <cmath>

namespace bslnav {
namespace {

constexpr Cost kYes = 255, kNo = 0;

/** Whether all cells of a window have a value. */
bool allAre(const CostGrid& grid, const CellWindow& window, Cost value) {
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x)
      if (grid.at(x, y) != value) return false;
  return true;
}

CellWindow around(const CostGrid& grid, int x, int y, int reach) {
  return CellWindow{x, y, x + 1, y + 1}.grown(reach).intersected(grid.bounds());
}

}  // namespace

void StandingThings::follow(const CostGrid& place) {
  const double r = place.getResolution();
  if (stands_.width() != place.width() || stands_.height() != place.height()) {
    stands_ = CostGrid(place.width(), place.height(), r, place.getXMin(), place.getYMin(), kNo);
    return;
  }
  const int dx = static_cast<int>(std::lround((place.getXMin() - stands_.getXMin()) / r));
  const int dy = static_cast<int>(std::lround((place.getYMin() - stands_.getYMin()) / r));
  if (dx != 0 || dy != 0) stands_.shift(dx, dy, kNo);
}

void StandingThings::forget(const CostGrid& empty,
                            const std::function<bool(const mrpt::math::TPoint2D&)>& isAsked) {
  for (int y = 0; y < stands_.height(); ++y) {
    Cost any = kNo;
    for (int x = 0; x < stands_.width(); ++x) any = static_cast<Cost>(any | stands_.at(x, y));
    for (int x = 0; any == kYes && x < stands_.width(); ++x)
      if (stands_.at(x, y) == kYes && allAre(empty, around(empty, x, y, 1), kYes) &&
          (!isAsked || isAsked({stands_.idx2x(x), stands_.idx2y(y)})))
        stands_.at(x, y) = kNo;
  }
}

void StandingThings::add(const mrpt::math::TPoint2D& from, const mrpt::math::TPoint2D& to) {
  const int steps = 1 + static_cast<int>(2.0 * (to - from).norm() / stands_.getResolution());
  for (int k = 0; k <= steps; ++k) {
    const auto p = from + (to - from) * (static_cast<double>(k) / steps);
    const int x = stands_.cellX(p.x), y = stands_.cellY(p.y);
    if (stands_.bounds().contains(x, y)) stands_.at(x, y) = kYes;
  }
}

bool StandingThings::isNear(const mrpt::math::TPoint2D& point, double distance_m) const {
  const int reach = static_cast<int>(std::ceil(distance_m / stands_.getResolution()));
  const int x = stands_.cellX(point.x), y = stands_.cellY(point.y);
  return !allAre(stands_, around(stands_, x, y, reach), kNo);
}

}  // namespace bslnav
