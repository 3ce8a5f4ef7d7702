#include <bslnav/blindspot/SeenPeople.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

constexpr double kForget_s = 1.0;      // a track not seen for so long ends
constexpr double kSmoothing = 0.4;     // part of a new velocity in the smoothed one
constexpr double kKnown_s = 0.25;      // before that a velocity is not known
constexpr double kWalking_mps = 0.35;  // slower, it may be the view of a thing that changes
constexpr double kSlack_m = 0.3;       // of the visible middle between two scans, besides walking

bool isNearSolid(const CostGrid& solid, const TPoint2D& p, int reach) {
  const int x0 = solid.cellX(p.x), y0 = solid.cellY(p.y);
  const CellWindow window =
      CellWindow{x0, y0, x0 + 1, y0 + 1}.grown(reach).intersected(solid.bounds());
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x)
      if (solid.at(x, y) != 0) return true;
  return false;
}

TPoint2D endOf(const PlanarScan& scan, std::size_t beam, const mrpt::math::TPose2D& mapFromRobot) {
  const auto& sensor = scan.robotFromSensor();
  const double range_m = scan.range_m[beam];
  return mapFromRobot.composePoint(
      TPoint2D{sensor.x + range_m * scan.cosine[beam], sensor.y + range_m * scan.sine[beam]});
}

/** Whether the beam beside one (`side` -1 or 1) ends on something nearer, or on what is next to it
 * and counts as the map's: then what the one hits may go on there. */
bool isCovered(const PlanarScan& scan, std::size_t beam, int side, double gap_m) {
  const std::size_t beside = beam + static_cast<std::size_t>(side);  // below 0: beyond the end
  return beside < scan.beam.size() && scan.beam[beside] == PlanarScan::Beam::Hit &&
         scan.range_m[beside] < scan.range_m[beam] + gap_m;
}

}  // namespace

void SeenPeopleParameters::describe(ConfigSection& section) {
  section.number("cluster_gap_m", clusterGap_m, kPositive, "m", "hits this near are of one thing");
  section.number("map_tolerance_m", mapTolerance_m, kNonNegative, "m",
                 "a hit this near to an occupied cell of the map is the map's");
  section.number("narrowest_m", narrowest_m, kNonNegative, "m",
                 "what is narrower and stands still is an obstacle, not a person");
  section.number("widest_m", widest_m, kPositive, "m",
                 "what is wider is an obstacle, not a person");
  section.number("lowest_m", lowest_m, kNonNegative, "m",
                 "what a depth camera sees whole and lower is an obstacle, not a person");
  section.number("standing_s", standing_s, kNonNegative, "s",
                 "so long has what is narrower than a person to stand still");
  section.number("still_within_m", stillWithin_m, kPositive, "m",
                 "the middle of what stands still stays within this distance and half its width");
}

void SeenPeople::update(const Views& views, double stamp_s, const mrpt::math::TPose2D& mapFromRobot,
                        const CostGrid& solid, double personSpeed_mps) {
  if (views.lasers.empty() && views.cameras.empty()) return;
  points_.clear();
  things_.clear();
  frontier_.clear();
  for (const PlanarScan* scan : views.lasers) findThings(*scan, mapFromRobot, solid);
  findTops(views.obstacles, mapFromRobot);
  for (Thing& thing : things_) thing.isLow = isLow(thing);
  for (const PlanarScan* scan : views.cameras) findThings(*scan, mapFromRobot, solid);
  for (Thing& thing : things_) {
    if (thing.another) {
      thing.mayWalk = things_[*thing.another].mayWalk;
    } else {
      Track& track = trackOf(thing, stamp_s, personSpeed_mps);
      follow(track, thing, stamp_s);
      thing.mayWalk = track.mayWalk;
    }
    if (!thing.mayWalk) continue;
    for (std::size_t i = thing.first; i < thing.first + thing.count; ++i)
      frontier_.push_back({static_cast<float>(points_[i].x), static_cast<float>(points_[i].y),
                           FrontierPoint::Kind::Seen});
  }
  tracks_.erase(
      std::remove_if(tracks_.begin(), tracks_.end(),
                     [stamp_s](const Track& t) { return stamp_s - t.lastSeen_s > kForget_s; }),
      tracks_.end());
  findMovers(stamp_s);
}

void SeenPeople::findMovers(double stamp_s) {
  movers_.clear();
  for (const Track& track : tracks_) {
    const bool known = track.lastSeen_s - track.firstSeen_s >= kKnown_s;
    if (!track.mayWalk || !known || track.velocity.norm() < kWalking_mps) continue;
    const double unseen_s = stamp_s - track.lastSeen_s;
    movers_.push_back({track.position + track.velocity * unseen_s, track.velocity});
  }
}

void SeenPeople::findThings(const PlanarScan& scan, const mrpt::math::TPose2D& mapFromRobot,
                            const CostGrid& solid) {
  const int reach = static_cast<int>(std::ceil(parameters_.mapTolerance_m / solid.getResolution()));
  const std::size_t others = things_.size();
  std::size_t first = points_.size(), firstBeam = 0, lastBeam = 0;
  const auto add = [&] {
    addThing(first, others,
             isCovered(scan, firstBeam, -1, parameters_.clusterGap_m) ||
                 isCovered(scan, lastBeam, 1, parameters_.clusterGap_m));
  };
  for (std::size_t k = 0; k < scan.beam.size(); ++k) {
    if (scan.beam[k] != PlanarScan::Beam::Hit) continue;
    const TPoint2D p = endOf(scan, k, mapFromRobot);
    if (!solid.bounds().contains(solid.cellX(p.x), solid.cellY(p.y))) continue;
    if (isNearSolid(solid, p, reach)) continue;
    const bool joined =
        points_.size() > first && (points_.back() - p).norm() <= parameters_.clusterGap_m;
    if (!joined) {
      add();
      first = points_.size();
      firstBeam = k;
    }
    points_.push_back(p);
    lastBeam = k;
  }
  add();
}

/** @param others so many things are of the scans before */
void SeenPeople::addThing(std::size_t first, std::size_t others, bool isCovered) {
  if (points_.size() == first) return;
  TPoint2D sum;
  double width = 0.0;
  for (std::size_t i = first; i < points_.size(); ++i) {
    sum += points_[i];
    width = std::max(width, (points_[i] - points_[first]).norm());
  }
  const auto count = points_.size() - first;
  Thing thing{first,        count,     sum * (1.0 / static_cast<double>(count)),
              width,        isCovered, std::nullopt,
              std::nullopt, true};
  thing.another = findAnother(thing, others);
  things_.push_back(thing);
}

/** The thing in a scan before that this one touches. Low ones do not count: who stands behind one
 * is seen above it. */
std::optional<std::size_t> SeenPeople::findAnother(const Thing& thing, std::size_t others) const {
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

void SeenPeople::findTops(const std::vector<const PlanarScan*>& scans,
                          const mrpt::math::TPose2D& mapFromRobot) {
  tops_.clear();
  for (const PlanarScan* scan : scans)
    for (std::size_t k = 0; k < scan->beam.size(); ++k) {
      if (scan->beam[k] != PlanarScan::Beam::Hit) continue;
      const double highestView_m =
          scan->sensorHeight_m + static_cast<double>(scan->range_m[k] * scan->steepest[k]);
      tops_.push_back({endOf(*scan, k, mapFromRobot), static_cast<double>(scan->top_m[k]),
                       highestView_m >= parameters_.lowest_m});
    }
}

/** Whether what is seen near all points of a thing is lower than people; nullopt if part of that
 * was not seen, or not up to their height. */
std::optional<bool> SeenPeople::isLow(const Thing& thing) const {
  if (thing.width_m > parameters_.widest_m) return std::nullopt;  // nor does it matter
  const double gap_m = parameters_.clusterGap_m;
  bool whole = true;
  for (std::size_t i = thing.first; i < thing.first + thing.count; ++i) {
    bool found = false;
    for (const Top& top : tops_) {
      if ((top.at - points_[i]).sqrNorm() > gap_m * gap_m) continue;
      if (top.height_m >= parameters_.lowest_m) return false;
      found = true;
      whole = whole && top.isWhole;
    }
    whole = whole && found;
  }
  return whole ? std::optional<bool>(true) : std::nullopt;
}

/** The nearest track that is not further on already, or a new one. */
Track& SeenPeople::trackOf(const Thing& thing, double stamp_s, double personSpeed_mps) {
  Track* nearest = nullptr;
  double least = 0.0;
  for (Track& track : tracks_) {
    if (track.lastSeen_s >= stamp_s) continue;
    const double elapsed_s = stamp_s - track.lastSeen_s;
    const double distance = (track.position + track.velocity * elapsed_s - thing.middle).norm();
    if (distance > personSpeed_mps * elapsed_s + kSlack_m) continue;
    if (nearest && distance >= least) continue;
    nearest = &track;
    least = distance;
  }
  if (nearest) return *nearest;
  Track track;
  track.position = track.stoodAt = thing.middle;
  track.firstSeen_s = track.lastSeen_s = track.stillSince_s = stamp_s;
  tracks_.push_back(track);
  return tracks_.back();
}

void SeenPeople::follow(Track& track, const Thing& thing, double stamp_s) const {
  const double elapsed_s = stamp_s - track.lastSeen_s;
  if (elapsed_s > 0.0) {
    const TPoint2D measured = (thing.middle - track.position) * (1.0 / elapsed_s);
    track.velocity = track.velocity * (1.0 - kSmoothing) + measured * kSmoothing;
  }
  track.position = thing.middle;
  track.lastSeen_s = stamp_s;
  track.width_m = std::max(track.width_m, thing.width_m);
  // What is seen of a thing from here and from there has its middle up to half a width away.
  if ((thing.middle - track.stoodAt).norm() > parameters_.stillWithin_m + 0.5 * track.width_m) {
    // The middle of what comes into view moves, too: only what stood whole can be seen to walk.
    track.hasMoved = track.hasMoved || stamp_s - track.firstSeen_s > parameters_.standing_s;
    track.stoodAt = thing.middle;
    track.stillSince_s = stamp_s;
    track.isLow = false;
  }
  track.isLow = thing.isLow.value_or(track.isLow);
  const bool asWideAsPeople = (track.width_m >= parameters_.narrowest_m || thing.isCovered) &&
                              track.width_m <= parameters_.widest_m;
  const bool stands = stamp_s - track.stillSince_s >= parameters_.standing_s;
  const bool isWide = track.width_m > parameters_.widest_m;
  track.mayWalk = !track.isLow && (asWideAsPeople || (!isWide && (track.hasMoved || !stands)));
}

}  // namespace bslnav
