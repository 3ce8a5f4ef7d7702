#include <bslnav/blindspot/SeenThings.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

constexpr double kBeside_m = 0.65;   // so far from a hit somebody who is hidden matters for it
constexpr double kObstacle_m = 0.7;  // so near to one are its other sides
constexpr double kWalker_m = 0.6;  // so near to the middle of a walker are two abreast, and a step
constexpr float kSameSurface_m = 0.15f;  // neighbouring beams of a surface differ by no more
constexpr double kStraight_m = 0.03;     // hits of something straight lie so near to a line

TPoint2D endOf(const PlanarScan& scan, std::size_t beam, const mrpt::math::TPose2D& mapFromRobot) {
  const auto& sensor = scan.robotFromSensor();
  const double range_m = scan.range_m[beam];
  return mapFromRobot.composePoint(
      TPoint2D{sensor.x + range_m * scan.cosine[beam], sensor.y + range_m * scan.sine[beam]});
}

/** Whether the beam beside one (`side` -1 or 1) ends on something nearer, or on what is next to it:
 * then what the one hits may go on there, as it may at the edge of the view. */
bool isCovered(const PlanarScan& scan, std::size_t beam, int side, double gap_m) {
  const auto step = static_cast<std::size_t>(side);  // below 0: beyond the end
  for (std::size_t k = beam + step; k < scan.beam.size(); k += step)
    if (scan.beam[k] != PlanarScan::Beam::Dropped)
      return scan.beam[k] == PlanarScan::Beam::Hit && scan.range_m[k] < scan.range_m[beam] + gap_m;
  return true;
}

/** Whether neighbouring beams meet the same surface, as far as their ranges tell. */
bool isJoined(const PlanarScan& scan, std::size_t beam, std::size_t neighbour) {
  return neighbour < scan.beam.size() && scan.beam[neighbour] == PlanarScan::Beam::Hit &&
         std::abs(scan.range_m[neighbour] - scan.range_m[beam]) <= kSameSurface_m;
}

using Points = std::vector<TPoint2D>::const_iterator;

/** How far the farthest of some points is from the first. */
double widthOf(Points first, Points end) {
  double width_m = 0.0;
  for (Points p = first; p != end; ++p) width_m = std::max(width_m, (*p - *first).norm());
  return width_m;
}

}  // namespace

bool SeenThings::Place::isReached(const TPoint2D& p, double distance_m) const {
  const int reach = static_cast<int>(std::ceil(distance_m / mapped.getResolution()));
  const int x = mapped.cellX(p.x), y = mapped.cellY(p.y);
  const CellWindow near = CellWindow{x, y, x + 1, y + 1}.grown(reach).intersected(mapped.bounds());
  const bool throughWalls = !standing.isNear(p, kObstacle_m);
  for (int row = near.y0; row < near.y1; ++row)
    for (int column = near.x0; column < near.x1; ++column)
      if (reached.at(column, row) && (throughWalls || !isBehindWall(x, y, column, row)))
        return true;
  return false;
}

bool SeenThings::Place::isBehindWall(int fromX, int fromY, int toX, int toY) const {
  const int steps = std::max(std::abs(toX - fromX), std::abs(toY - fromY));
  const float dx = static_cast<float>(toX - fromX) / static_cast<float>(steps);
  const float dy = static_cast<float>(toY - fromY) / static_cast<float>(steps);
  bool inFirst = true;
  for (int k = 0; k < steps; ++k) {
    const int x = fromX + static_cast<int>(std::lrint(static_cast<float>(k) * dx));
    const int y = fromY + static_cast<int>(std::lrint(static_cast<float>(k) * dy));
    const bool isWall = walls.bounds().contains(x, y) && walls.at(x, y) != 0;
    if (isWall && !inFirst) return true;
    inFirst = inFirst && isWall;
  }
  return false;
}

void SeenThings::find(const Views& views, const mrpt::math::TPose2D& mapFromRobot,
                      const Place& place, const std::vector<TPoint2D>& walkers) {
  walkers_ = walkers;
  points_.clear();
  is_.clear();
  things_.clear();
  obstacles_.clear();
  for (const PlanarScan* scan : views.lasers) findThings(*scan, mapFromRobot, place);
  findTops(views.obstacles, mapFromRobot);
  for (Thing& thing : things_) thing.isLow = isLow(thing);
  for (const PlanarScan* scan : views.cameras) findThings(*scan, mapFromRobot, place);
}

void SeenThings::findThings(const PlanarScan& scan, const mrpt::math::TPose2D& mapFromRobot,
                            const Place& place) {
  const std::size_t others = things_.size();
  std::size_t first = points_.size(), firstBeam = 0, lastBeam = 0;
  const auto add = [&] {
    if (points_.size() == first) return;
    const bool before = isCovered(scan, firstBeam, -1, parameters_.clusterGap_m);
    const bool after = isCovered(scan, lastBeam, 1, parameters_.clusterGap_m);
    const auto begin = points_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto isBegin = is_.begin() + static_cast<std::ptrdiff_t>(first);
    // What is too narrow for a person as a whole, stands in part, and is where nobody can have come
    // to unseen, is the same obstacle.
    const bool stands = std::find(isBegin, is_.end(), Is::Standing) != is_.end();
    if (stands && !before && !after && widthOf(begin, points_.end()) < parameters_.narrowest_m &&
        !place.isReached(*begin, kBeside_m))
      std::replace(isBegin, is_.end(), Is::New, Is::Obstacle);
    addThings(first, others, before, after);
  };
  for (std::size_t k = 0; k < scan.beam.size(); ++k) {
    if (scan.beam[k] != PlanarScan::Beam::Hit) continue;
    const TPoint2D p = endOf(scan, k, mapFromRobot);
    const int x = place.mapped.cellX(p.x), y = place.mapped.cellY(p.y);
    if (!place.mapped.bounds().contains(x, y)) continue;
    const bool joined =
        points_.size() > first && (points_.back() - p).norm() <= parameters_.clusterGap_m;
    if (!joined) {
      add();
      first = points_.size();
      firstBeam = k;
    }
    points_.push_back(p);
    const bool mapped = place.mapped.at(x, y) != 0;
    const bool stands = mapped || place.standing.isNear(p, parameters_.standingTolerance_m);
    is_.push_back(mapped ? Is::Mapped : stands ? Is::Standing : Is::New);
    lastBeam = k;
  }
  add();
}

/** Makes things of joined hits, from `first` on: what is straight is an obstacle, and each run of
 * hits that nothing explains is a thing for itself.
 *  @param others so many things are of the scans before */
void SeenThings::addThings(std::size_t first, std::size_t others, bool coveredBefore,
                           bool coveredAfter) {
  findStraight(first, points_.size() - 1);
  for (std::size_t i = first; i < points_.size();) {
    if (is_[i] == Is::Obstacle) obstacles_.push_back(points_[i]);
    if (is_[i] != Is::New) {
      ++i;
      continue;
    }
    const std::size_t from = i;
    while (i < points_.size() && is_[i] == Is::New) ++i;
    const bool covered = from > first || coveredBefore || i < points_.size() || coveredAfter;
    addThing(from, i, others, covered);
  }
}

bool SeenThings::isBesideWalker(const TPoint2D& p) const {
  return std::any_of(walkers_.begin(), walkers_.end(), [&p](const TPoint2D& walker) {
    return (walker - p).sqrNorm() <= kWalker_m * kWalker_m;
  });
}

/** Notes the pieces between two hits that are too long and straight for a person: between the ends
 * of a piece all hits are near its chord, else it is halved where one is farthest from it. People
 * who walk past each other look so for a moment. */
void SeenThings::findStraight(std::size_t first, std::size_t last) {
  const TPoint2D chord = points_[last] - points_[first];
  const double length = chord.norm();
  std::size_t farthest = first;
  double most = kStraight_m;
  double widest = length;  // a thing may come back to where it begins
  for (std::size_t i = first + 1; i < last; ++i) {
    const TPoint2D p = points_[i] - points_[first];
    const double off = length > 1e-6 ? std::abs(chord.x * p.y - chord.y * p.x) / length : p.norm();
    widest = std::max(widest, p.norm());
    if (off <= most) continue;
    most = off;
    farthest = i;
  }
  if (widest < parameters_.straight_m) return;
  if (farthest == first) {
    if (length < parameters_.straight_m) return;
    for (std::size_t i = first; i <= last; ++i)
      if (is_[i] != Is::Mapped && !isBesideWalker(points_[i])) is_[i] = Is::Obstacle;
    return;
  }
  findStraight(first, farthest);
  findStraight(farthest, last);
}

void SeenThings::addThing(std::size_t first, std::size_t end, std::size_t others, bool isCovered) {
  const auto from = points_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto to = points_.begin() + static_cast<std::ptrdiff_t>(end);
  const auto count = end - first;
  const TPoint2D middle =
      std::accumulate(from, to, TPoint2D()) * (1.0 / static_cast<double>(count));
  const bool beside =
      std::any_of(from, to, [this](const TPoint2D& p) { return isBesideWalker(p); });
  Thing thing{first,     count,  middle,       widthOf(from, to),
              isCovered, beside, std::nullopt, std::nullopt};
  thing.another = findAnother(thing, others);
  things_.push_back(thing);
}

/** The thing in a scan before that this one touches. Low ones do not count: who stands behind one
 * is seen above it. */
std::optional<std::size_t> SeenThings::findAnother(const Thing& thing, std::size_t others) const {
  const double gap_m = parameters_.clusterGap_m;
  for (std::size_t k = 0; k < others; ++k) {
    const Thing& other = things_[k];
    if (other.another || other.isLow.value_or(false)) continue;
    // No point is farther from the middle than twice the width.
    const double farthest_m = gap_m + 2.0 * (thing.width_m + other.width_m);
    if ((thing.middle - other.middle).norm() > farthest_m) continue;
    for (std::size_t i = other.first; i < other.first + other.count; ++i)
      for (std::size_t j = thing.first; j < thing.first + thing.count; ++j)
        if ((points_[i] - points_[j]).sqrNorm() <= gap_m * gap_m) return k;
  }
  return std::nullopt;
}

void SeenThings::findTops(const std::vector<const PlanarScan*>& scans,
                          const mrpt::math::TPose2D& mapFromRobot) {
  tops_.clear();
  for (const PlanarScan* scan : scans)
    for (std::size_t k = 0; k < scan->beam.size(); ++k) {
      if (scan->beam[k] != PlanarScan::Beam::Hit) continue;
      const double highestView_m =
          scan->sensorHeight_m + static_cast<double>(scan->range_m[k] * scan->steepest[k]);
      const bool isEdge = !isJoined(*scan, k, k - 1) || !isJoined(*scan, k, k + 1);
      tops_.push_back({endOf(*scan, k, mapFromRobot), static_cast<double>(scan->top_m[k]),
                       highestView_m >= parameters_.lowest_m, isEdge});
    }
}

/** Whether what is seen near all points of a thing is lower than people; nullopt if part of that
 * was not seen, or not up to their height. */
std::optional<bool> SeenThings::isLow(const Thing& thing) const {
  if (thing.width_m > parameters_.widest_m) return std::nullopt;  // nor does it matter
  const double gap_m = parameters_.clusterGap_m;
  bool whole = true;
  for (std::size_t i = thing.first; i < thing.first + thing.count; ++i) {
    bool found = false;
    for (const Top& top : tops_) {
      if ((top.at - points_[i]).sqrNorm() > gap_m * gap_m) continue;
      if (top.height_m >= parameters_.lowest_m) return false;
      if (top.isEdge) continue;
      found = true;
      whole = whole && top.isWhole;
    }
    whole = whole && found;
  }
  return whole ? std::optional<bool>(true) : std::nullopt;
}

}  // namespace bslnav
