#include <bslnav/blindspot/HiddenPeople.h>

#include <algorithm>
#include <cmath>

#include "GridAround.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

constexpr double kDeepest_m = 1.0;        // so far a thing goes on behind what a laser meets of it
constexpr double kSquareSteps = 0.41422;  // √2 − 1: the share with which diagonals keep up

}  // namespace

HiddenPeople::HiddenPeople(const HiddenPeopleParameters& parameters, double bodyRadius_m,
                           const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map,
                           const StaticParameters& mapThresholds)
    : parameters_(parameters),
      bodyRadius_m_(bodyRadius_m),
      map_(map, mapThresholds, parameters.reach_m, parameters.resolution_m,
           parameters.mapTolerance_m),
      seen_(parameters.reach_m, parameters.resolution_m),
      possible_(gridAround(parameters.reach_m, parameters.resolution_m)),
      possibleBits_(possible_.width(), possible_.height()),
      blockedBits_(possibleBits_),
      workBits_(possibleBits_),
      reachedBits_(possibleBits_),
      // Rounded down: a person fits rather into too little than not into what is enough.
      personRadius_cells_(std::max(
          0, static_cast<int>(std::floor(parameters.radius_m / parameters.resolution_m - 0.5)))) {}

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
  started_ = true;
  mapFromRobot_ = mapFromRobot;
  recentre(possible_, mapFromRobot.x, mapFromRobot.y);
  map_.follow(mapFromRobot);
  standing_.follow(map_.walls());
  seen_.begin(mapFromRobot, stamp_s_);
  lookWith(lasers, cameras);
  grow(personSpeed_mps * elapsed_s);
  hasBlindSide_ = parameters_.outsideView == HiddenPeopleParameters::OutsideView::Free &&
                  seen_.takeOutsideView(parameters_.lookMemory_s, possible_);
}

void HiddenPeople::lookWith(const Scans& lasers, const Scans& cameras) {
  laserViews_.resize(lasers.size());
  for (std::size_t k = 0; k < lasers.size(); ++k) {
    laserViews_[k].assign(*lasers[k], parameters_.gap_m);
    seen_.add(laserViews_[k], map_.mapped());
  }
  standing_.forget(seen_.empty());
  if (cameras.empty()) return;
  for (const PlanarScan* scan : cameras) {
    view_.assign(*scan, parameters_.gap_m);
    seen_.add(view_, map_.mapped());
  }
  standing_.forget(seen_.empty(), [this](const TPoint2D& p) { return !isUpToLasers(p); });
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
  seen_.takeRoom({mapFromRobot_.x, mapFromRobot_.y}, bodyRadius_m_);
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

/** People walk on, through everything but walls and obstacles, and may come in at the edge of the
 * grid. Cells are taken before they are reached, never after; steps along four and eight neighbours
 * are mixed to the regular octagon, the smallest that holds the circle. */
void HiddenPeople::grow(double distance_m) {
  blockedBits_.assign(seen_.surfaces());
  blockedBits_.add(map_.wallBits());
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
    squaresOwed_ += kSquareSteps;
    if (squaresOwed_ > 0.0) {
      possibleBits_.growSquare();
      squaresOwed_ -= 1.0;
    } else {
      possibleBits_.growCross();
    }
    possibleBits_.remove(blockedBits_);
  }
  possibleBits_.remove(blockedBits_);
  possibleBits_.copyTo(possible_);
  reachedBits_ = possibleBits_;
}

/** Takes the room of people who are seen. */
void HiddenPeople::takeBodies(const std::vector<TPoint2D>& bodies) {
  const TPoint2D robot(mapFromRobot_.x, mapFromRobot_.y);
  for (const TPoint2D& nearest : bodies) {
    const TPoint2D ray = nearest - robot;
    seen_.takeRoom(nearest + ray * (parameters_.radius_m / std::max(ray.norm(), 1e-6)),
                   parameters_.radius_m);
  }
}

void HiddenPeople::keepWhereSomebodyFits() {
  BitGrid& room = workBits_;
  room.assign(seen_.empty());
  room.add(map_.wallBits());
  room.invert();
  room.openDisc(personRadius_cells_);
  possibleBits_.keep(room);
}

/** Leaves in workBits_ the cells that are free of people and connected with the robot, through
 * whatever is neither a wall nor possible: seen, or hidden where nobody fits. Behind walls there
 * are such cells, too, but nobody walks from there to the robot. */
void HiddenPeople::floodFromRobot() {
  blockedBits_.add(possibleBits_);
  blockedBits_.invert();
  workBits_.clear();
  const CellWindow window =
      cellsAround(possible_, {mapFromRobot_.x, mapFromRobot_.y}, bodyRadius_m_);
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x) workBits_.set(x, y);
  workBits_.flood(blockedBits_);
}

}  // namespace bslnav
