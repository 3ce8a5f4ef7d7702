#include <bslnav/blindspot/HiddenPeople.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "PolarRow.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

constexpr Cost kYes = 255, kNo = 0;
constexpr double kDeepest_m = 1.0;  // so far a thing goes on behind what a laser meets of it

void fill(CostGrid& grid, Cost value) {
  std::fill(grid.row(0), grid.row(0) + std::ptrdiff_t{grid.width()} * grid.height(), value);
}

/** An odd number of cells that reach as far to each side. */
CostGrid gridAround(double reach_m, double resolution_m) {
  const int half = static_cast<int>(std::ceil(reach_m / resolution_m));
  return CostGrid(2 * half + 1, 2 * half + 1, resolution_m, -half * resolution_m,
                  -half * resolution_m, kYes);
}

std::optional<StaticLayer> staticLayer(const mrpt::maps::COccupancyGridMap2D* map,
                                       double resolution_m, const StaticParameters& thresholds) {
  if (!map) return std::nullopt;
  return StaticLayer(*map, resolution_m, thresholds);
}

}  // namespace

HiddenPeople::HiddenPeople(const HiddenPeopleParameters& parameters, double bodyRadius_m,
                           const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map,
                           const StaticParameters& mapThresholds)
    : parameters_(parameters),
      bodyRadius_m_(bodyRadius_m),
      static_(staticLayer(map.get(), parameters.resolution_m, mapThresholds)),
      possible_(gridAround(parameters.reach_m, parameters.resolution_m)),
      seen_(possible_),
      surface_(possible_),
      solid_(possible_),
      mapped_(possible_),
      possibleBits_(possible_.width(), possible_.height()),
      blockedBits_(possibleBits_),
      workBits_(possibleBits_),
      solidBits_(possibleBits_),
      reachedBits_(possibleBits_),
      // Rounded down: a person fits rather into too little than not into what is enough.
      personRadius_cells_(std::max(
          0, static_cast<int>(std::floor(parameters.radius_m / parameters.resolution_m - 0.5)))),
      directions_(possible_.getSizeX()),
      squared_(possible_.getSizeX()),
      lookedAt_s_(ScanView::kDirections, std::numeric_limits<double>::lowest()) {
  fill(solid_, kNo);
  fill(mapped_, kNo);
}

void HiddenPeople::update(const Scans& lasers, double stamp_s,
                          const mrpt::math::TPose2D& mapFromRobot, double personSpeed_mps) {
  if (lasers.empty()) return;
  look(lasers, {}, stamp_s, mapFromRobot, personSpeed_mps);
  findFrontier({});
}

void HiddenPeople::look(const Scans& lasers, const Scans& cameras, double stamp_s,
                        const mrpt::math::TPose2D& mapFromRobot, double personSpeed_mps) {
  if (lasers.empty() && cameras.empty()) return;
  const double elapsed_s = started_ ? std::max(0.0, stamp_s - stamp_s_) : 0.0;
  stamp_s_ = started_ ? std::max(stamp_s, stamp_s_) : stamp_s;
  mapFromRobot_ = mapFromRobot;
  recentre();
  standing_.follow(solid_);
  started_ = true;
  fill(seen_, kNo);
  fill(surface_, kNo);
  laserViews_.resize(lasers.size());
  for (std::size_t k = 0; k < lasers.size(); ++k) {
    laserViews_[k].assign(*lasers[k], parameters_.gap_m);
    takeIn(laserViews_[k]);
  }
  standing_.forget(seen_);
  for (const PlanarScan* scan : cameras) {
    view_.assign(*scan, parameters_.gap_m);
    takeIn(view_);
  }
  if (!cameras.empty())
    standing_.forget(seen_, [this](const TPoint2D& p) { return !isUpToLasers(p); });
  grow(personSpeed_mps * elapsed_s);
  hasBlindSide_ = false;
  if (parameters_.outsideView == HiddenPeopleParameters::OutsideView::Free) forgetOutsideView();
}

void HiddenPeople::takeIn(const ScanView& view) {
  noteLooks(view);
  cutOut(view);
  markSurfaces(view);
}

/** Whether a laser looks at a place, or what it meets before that may be of the same thing. */
bool HiddenPeople::isUpToLasers(const TPoint2D& point) const {
  const TPoint2D inRobot = mapFromRobot_.inverseComposePoint(point);
  return std::any_of(laserViews_.begin(), laserViews_.end(), [&inRobot](const ScanView& view) {
    const double x = inRobot.x - view.origin().x, y = inRobot.y - view.origin().y;
    const double turn = 0.5 + std::atan2(y, x) / (2.0 * M_PI);  // from −π on
    const int direction = static_cast<int>(turn * ScanView::kDirections) % ScanView::kDirections;
    return view.looks(direction) &&
           std::hypot(x, y) <= std::sqrt(view.squaredReach(direction)) + kDeepest_m;
  });
}

void HiddenPeople::findFrontier(const std::vector<TPoint2D>& bodies) {
  takeRoom({mapFromRobot_.x, mapFromRobot_.y}, bodyRadius_m_);
  possibleBits_.assign(possible_);
  keepWhereSomebodyFits();
  possibleBits_.copyTo(possible_);
  if (!bodies.empty()) {  // they stay possible: who is seen now may walk behind something
    takeBodies(bodies);
    keepWhereSomebodyFits();
  }
  floodFromRobot();
  workBits_.growCross();
  workBits_.keep(possibleBits_);
  frontier_.clear();
  workBits_.forEach([this](int x, int y) {
    if (x == 0 || y == 0 || x + 1 == possible_.width() || y + 1 == possible_.height()) return;
    frontier_.push_back({static_cast<float>(possible_.idx2x(x)),
                         static_cast<float>(possible_.idx2y(y)), FrontierPoint::Kind::Hidden});
  });
}

void HiddenPeople::recentre() {
  const int half = possible_.width() / 2;
  const int dx = possible_.cellX(mapFromRobot_.x) - half;
  const int dy = possible_.cellY(mapFromRobot_.y) - half;
  if (dx == 0 && dy == 0 && started_) return;
  for (CostGrid* grid : {&possible_, &seen_, &surface_, &solid_, &mapped_})
    grid->shift(dx, dy, kYes);
  if (!static_) {
    fill(solid_, kNo);
    fill(mapped_, kNo);
    solidBits_.clear();
    return;
  }
  static_->copyTo(solid_, solid_.bounds());
  for (int y = 0; y < solid_.height(); ++y)
    for (int x = 0; x < solid_.width(); ++x)
      solid_.at(x, y) = solid_.at(x, y) == kLethalCost ? kYes : kNo;
  solidBits_.assign(solid_);
  workBits_ = solidBits_;
  const int reach =
      static_cast<int>(std::ceil(parameters_.mapTolerance_m / parameters_.resolution_m));
  for (int k = 0; k < reach; ++k) workBits_.growSquare();
  workBits_.copyTo(mapped_);
}

void HiddenPeople::cutOut(const ScanView& view) {
  const auto eye = mapFromRobot_.composePoint({view.origin().x, view.origin().y});
  const auto step = static_cast<float>(parameters_.resolution_m);
  const auto offset = static_cast<float>(-mapFromRobot_.phi * ScanView::kDirections / (2.0 * M_PI));
  const int width = seen_.width();
  for (int y = 0; y < seen_.height(); ++y) {
    polarRow(static_cast<float>(seen_.idx2x(0) - eye.x), static_cast<float>(seen_.idx2y(y) - eye.y),
             step, offset, width, directions_.data(), squared_.data());
    markNearer(directions_.data(), squared_.data(), view.squaredReach().data(), width,
               seen_.row(y));
  }
}

void HiddenPeople::noteLooks(const ScanView& view) {
  for (int i = 0; i < ScanView::kDirections; ++i)
    if (view.looks(i)) lookedAt_s_[static_cast<std::size_t>(i)] = stamp_s_;
}

bool HiddenPeople::looksBehind() const {
  constexpr std::ptrdiff_t kHalf = ScanView::kDirections / 12;  // 30° to each side
  const double oldest_s = stamp_s_ - parameters_.lookMemory_s;
  const auto isOld = [oldest_s](double time_s) { return time_s < oldest_s; };
  return std::none_of(lookedAt_s_.begin(), lookedAt_s_.begin() + kHalf, isOld) &&
         std::none_of(lookedAt_s_.end() - kHalf, lookedAt_s_.end(), isOld);
}

void HiddenPeople::markSurfaces(const ScanView& view) {
  const auto r = static_cast<float>(parameters_.resolution_m);
  const auto c = static_cast<float>(std::cos(mapFromRobot_.phi));
  const auto s = static_cast<float>(std::sin(mapFromRobot_.phi));
  const auto x0 = static_cast<float>((mapFromRobot_.x - surface_.getXMin()) / r);
  const auto y0 = static_cast<float>((mapFromRobot_.y - surface_.getYMin()) / r);
  for (const auto& piece : view.surfaces()) {
    const float dx = piece.to.x - piece.from.x, dy = piece.to.y - piece.from.y;
    const int steps = 1 + static_cast<int>(4.0f * std::sqrt(dx * dx + dy * dy) / r);
    for (int k = 0; k <= steps; ++k) {
      const float part = static_cast<float>(k) / static_cast<float>(steps);
      const float px = piece.from.x + part * dx, py = piece.from.y + part * dy;
      const int x = static_cast<int>(std::floor(x0 + (c * px - s * py) / r));
      const int y = static_cast<int>(std::floor(y0 + (s * px + c * py) / r));
      // Near walls of the map, the walls are in the way themselves, and a hit may be somebody's.
      if (surface_.bounds().contains(x, y) && mapped_.at(x, y) == kNo) surface_.at(x, y) = kYes;
    }
  }
}

/** People walk on, through everything but walls and obstacles, and may come in at the edge of the
 * grid. Cells are taken before they are reached, never after; steps along four and eight neighbours
 * take turns, whose octagon holds the circle. */
void HiddenPeople::grow(double distance_m) {
  blockedBits_.assign(surface_);
  blockedBits_.add(solidBits_);
  workBits_.assign(standing_.cells());
  blockedBits_.add(workBits_);
  // Nor does anybody slip through a gap that is too narrow for a person.
  blockedBits_.invert();
  blockedBits_.openDisc(personRadius_cells_);
  blockedBits_.invert();
  possibleBits_.assign(possible_);
  possibleBits_.addBorder();
  owed_m_ += distance_m;
  // Farther than the window is wide, everything is reached.
  const double most_m = possible_.width() * parameters_.resolution_m;
  for (owed_m_ = std::min(owed_m_, most_m); owed_m_ > 0.0; owed_m_ -= parameters_.resolution_m) {
    if (square_)
      possibleBits_.growSquare();
    else
      possibleBits_.growCross();
    possibleBits_.remove(blockedBits_);
    square_ = !square_;
  }
  possibleBits_.remove(blockedBits_);
  possibleBits_.copyTo(possible_);
  reachedBits_ = possibleBits_;
}

void HiddenPeople::forgetOutsideView() {
  std::array<int, ScanView::kDirections> away;
  const double oldest_s = stamp_s_ - parameters_.lookMemory_s;
  for (std::size_t i = 0; i < away.size(); ++i) away[i] = lookedAt_s_[i] < oldest_s ? kYes : kNo;
  hasBlindSide_ = std::count(away.begin(), away.end(), int{kYes}) > 0;
  if (!hasBlindSide_) return;
  const auto offset = static_cast<float>(-mapFromRobot_.phi * ScanView::kDirections / (2.0 * M_PI));
  for (int y = 0; y < possible_.height(); ++y) {
    polarRow(static_cast<float>(possible_.idx2x(0) - mapFromRobot_.x),
             static_cast<float>(possible_.idx2y(y) - mapFromRobot_.y),
             static_cast<float>(parameters_.resolution_m), offset, possible_.width(),
             directions_.data(), squared_.data());
    // No room for somebody in the strip beside the view of a sensor off the centre.
    markDirections(directions_.data(), away.data(), possible_.width(), seen_.row(y),
                   possible_.row(y));
  }
}

/** Nobody hides in a disc, nor between it and what is seen near it. */
void HiddenPeople::takeRoom(const TPoint2D& centre, double radius_m) {
  const CellWindow window = cellsAround(centre, radius_m);
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x)
      if (std::hypot(seen_.idx2x(x) - centre.x, seen_.idx2y(y) - centre.y) <= radius_m)
        seen_.at(x, y) = kYes;
}

/** Takes the room of people who are seen. */
void HiddenPeople::takeBodies(const std::vector<TPoint2D>& bodies) {
  const TPoint2D robot(mapFromRobot_.x, mapFromRobot_.y);
  for (const TPoint2D& nearest : bodies) {
    const TPoint2D ray = nearest - robot;
    takeRoom(nearest + ray * (parameters_.radius_m / std::max(ray.norm(), 1e-6)),
             parameters_.radius_m);
  }
}

void HiddenPeople::keepWhereSomebodyFits() {
  BitGrid& room = workBits_;
  room.assign(seen_);
  room.add(solidBits_);
  room.invert();
  room.openDisc(personRadius_cells_);
  possibleBits_.keep(room);
}

/** The square around a disc, as far as the grid reaches. */
CellWindow HiddenPeople::cellsAround(const TPoint2D& centre, double radius_m) const {
  const int reach = 1 + static_cast<int>(radius_m / parameters_.resolution_m);
  const int x = possible_.cellX(centre.x), y = possible_.cellY(centre.y);
  return CellWindow{x, y, x + 1, y + 1}.grown(reach).intersected(possible_.bounds());
}

/** Leaves in workBits_ the cells that are free of people and connected with the robot, through
 * whatever is neither a wall nor possible: seen, or hidden where nobody fits. Behind walls there
 * are such cells, too, but nobody walks from there to the robot. */
void HiddenPeople::floodFromRobot() {
  blockedBits_.add(possibleBits_);
  blockedBits_.invert();
  workBits_.clear();
  const CellWindow window = cellsAround({mapFromRobot_.x, mapFromRobot_.y}, bodyRadius_m_);
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x) workBits_.set(x, y);
  workBits_.flood(blockedBits_);
}

}  // namespace bslnav
