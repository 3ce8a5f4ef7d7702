#include <bslnav/blindspot/SeenArea.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "GridAround.h"
#include "PolarRow.h"

namespace bslnav {

SeenArea::SeenArea(double reach_m, double resolution_m)
    : empty_(gridAround(reach_m, resolution_m)),
      surfaces_(empty_),
      directions_(empty_.getSizeX()),
      squared_(empty_.getSizeX()),
      lookedAt_s_(ScanView::kDirections, std::numeric_limits<double>::lowest()) {}

void SeenArea::begin(const mrpt::math::TPose2D& mapFromRobot, double stamp_s) {
  mapFromRobot_ = mapFromRobot;
  stamp_s_ = stamp_s;
  for (CostGrid* grid : {&empty_, &surfaces_}) {
    recentre(*grid, mapFromRobot.x, mapFromRobot.y);
    fill(*grid, kNo);
  }
}

void SeenArea::add(const ScanView& view, const CostGrid& mapped) {
  noteLooks(view);
  cutOut(view);
  markSurfaces(view, mapped);
}

void SeenArea::noteLooks(const ScanView& view) {
  for (int i = 0; i < ScanView::kDirections; ++i)
    if (view.looks(i)) lookedAt_s_[static_cast<std::size_t>(i)] = stamp_s_;
}

void SeenArea::cutOut(const ScanView& view) {
  const auto eye = mapFromRobot_.composePoint({view.origin().x, view.origin().y});
  const auto step = static_cast<float>(empty_.getResolution());
  const auto offset = static_cast<float>(-mapFromRobot_.phi * ScanView::kDirections / (2.0 * M_PI));
  const int width = empty_.width();
  for (int y = 0; y < empty_.height(); ++y) {
    polarRow(static_cast<float>(empty_.idx2x(0) - eye.x),
             static_cast<float>(empty_.idx2y(y) - eye.y), step, offset, width, directions_.data(),
             squared_.data());
    markNearer(directions_.data(), squared_.data(), view.squaredReach().data(), width,
               empty_.row(y));
  }
}

void SeenArea::markSurfaces(const ScanView& view, const CostGrid& mapped) {
  const auto r = static_cast<float>(surfaces_.getResolution());
  const auto c = static_cast<float>(std::cos(mapFromRobot_.phi));
  const auto s = static_cast<float>(std::sin(mapFromRobot_.phi));
  const auto x0 = static_cast<float>((mapFromRobot_.x - surfaces_.getXMin()) / r);
  const auto y0 = static_cast<float>((mapFromRobot_.y - surfaces_.getYMin()) / r);
  for (const auto& piece : view.surfaces()) {
    const float dx = piece.to.x - piece.from.x, dy = piece.to.y - piece.from.y;
    const int steps = 1 + static_cast<int>(4.0f * std::sqrt(dx * dx + dy * dy) / r);
    for (int k = 0; k <= steps; ++k) {
      const float part = static_cast<float>(k) / static_cast<float>(steps);
      const float px = piece.from.x + part * dx, py = piece.from.y + part * dy;
      const int x = static_cast<int>(std::floor(x0 + (c * px - s * py) / r));
      const int y = static_cast<int>(std::floor(y0 + (s * px + c * py) / r));
      // Near walls of the map, the walls are in the way themselves, and a hit may be somebody's.
      if (surfaces_.bounds().contains(x, y) && mapped.at(x, y) == kNo) surfaces_.at(x, y) = kYes;
    }
  }
}

void SeenArea::takeRoom(const mrpt::math::TPoint2D& centre, double radius_m) {
  const CellWindow window = cellsAround(empty_, centre, radius_m);
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x)
      if (std::hypot(empty_.idx2x(x) - centre.x, empty_.idx2y(y) - centre.y) <= radius_m)
        empty_.at(x, y) = kYes;
}

bool SeenArea::takeOutsideView(double lookMemory_s, CostGrid& cleared) {
  std::array<int, ScanView::kDirections> away;
  const double oldest_s = stamp_s_ - lookMemory_s;
  for (std::size_t i = 0; i < away.size(); ++i) away[i] = lookedAt_s_[i] < oldest_s ? kYes : kNo;
  if (std::count(away.begin(), away.end(), int{kYes}) == 0) return false;
  const auto offset = static_cast<float>(-mapFromRobot_.phi * ScanView::kDirections / (2.0 * M_PI));
  for (int y = 0; y < empty_.height(); ++y) {
    polarRow(static_cast<float>(empty_.idx2x(0) - mapFromRobot_.x),
             static_cast<float>(empty_.idx2y(y) - mapFromRobot_.y),
             static_cast<float>(empty_.getResolution()), offset, empty_.width(), directions_.data(),
             squared_.data());
    // No room for somebody in the strip beside the view of a sensor off the centre.
    markDirections(directions_.data(), away.data(), empty_.width(), empty_.row(y), cleared.row(y));
  }
  return true;
}

bool SeenArea::looksBehind(double lookMemory_s) const {
  constexpr std::ptrdiff_t kHalf = ScanView::kDirections / 12;  // 30° to each side
  const double oldest_s = stamp_s_ - lookMemory_s;
  const auto isOld = [oldest_s](double time_s) { return time_s < oldest_s; };
  return std::none_of(lookedAt_s_.begin(), lookedAt_s_.begin() + kHalf, isOld) &&
         std::none_of(lookedAt_s_.end() - kHalf, lookedAt_s_.end(), isOld);
}

}  // namespace bslnav
