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
constexpr double kStraight_m = 0.03;   // hits of something straight lie so near to a line
constexpr double kSlack_m = 0.3;       // of the visible middle between two scans, besides walking

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

}  // namespace

void SeenPeopleParameters::describe(ConfigSection& section) {
  section.number("cluster_gap_m", clusterGap_m, kPositive, "m", "hits this near are of one thing");
  section.number("standing_tolerance_m", standingTolerance_m, kNonNegative, "m",
                 "a hit this near to an obstacle that was seen to stand is of it");
  section.number("narrowest_m", narrowest_m, kNonNegative, "m",
                 "what is narrower and stands still is an obstacle, not a person");
  section.number("widest_m", widest_m, kPositive, "m",
                 "what is wider is an obstacle, not people side by side");
  section.number("straight_m", straight_m, kPositive, "m",
                 "what is straight over so much is an obstacle, not a person");
  section.number("lowest_m", lowest_m, kNonNegative, "m",
                 "what a depth camera sees whole and lower is an obstacle, not a person");
  section.number("standing_s", standing_s, kNonNegative, "s",
                 "so long has what is narrower than a person to stand still");
  section.number("person_standing_s", personStanding_s, kNonNegative, "s",
                 "past somebody who has stood so long, the robot may creep");
  section.number("still_within_m", stillWithin_m, kPositive, "m",
                 "the middle of what stands still stays within this distance and half its width");
}

void SeenPeople::update(const Views& views, double stamp_s, const mrpt::math::TPose2D& mapFromRobot,
                        const Place& place, double personSpeed_mps) {
  if (views.lasers.empty() && views.cameras.empty()) return;
  points_.clear();
  is_.clear();
  things_.clear();
  obstacles_.clear();
  frontier_.clear();
  for (const PlanarScan* scan : views.lasers) findThings(*scan, mapFromRobot, place);
  findTops(views.obstacles, mapFromRobot);
  for (Thing& thing : things_) thing.isLow = isLow(thing);
  for (const PlanarScan* scan : views.cameras) findThings(*scan, mapFromRobot, place);
  for (Thing& thing : things_) {
    judge(thing, stamp_s, personSpeed_mps);
    if (!thing.mayWalk) continue;
    const auto kind = thing.stands ? FrontierPoint::Kind::Standing : FrontierPoint::Kind::Seen;
    for (std::size_t i = thing.first; i < thing.first + thing.count; ++i)
      frontier_.push_back(
          {static_cast<float>(points_[i].x), static_cast<float>(points_[i].y), kind});
  }
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    const TPoint2D& before = obstacles_[i == 0 ? 0 : i - 1];
    const bool joined = (before - obstacles_[i]).norm() <= parameters_.clusterGap_m;
    place.standing.add(joined ? before : obstacles_[i], obstacles_[i]);
  }
  tracks_.erase(
      std::remove_if(tracks_.begin(), tracks_.end(),
                     [stamp_s](const Track& t) { return stamp_s - t.lastSeen_s > kForget_s; }),
      tracks_.end());
  findMovers(stamp_s);
}

void SeenPeople::judge(Thing& thing, double stamp_s, double personSpeed_mps) {
  if (thing.another) {
    thing.mayWalk = things_[*thing.another].mayWalk;
    thing.stands = things_[*thing.another].stands;
    return;
  }
  thing.mayWalk = !thing.isLow.value_or(false) && thing.width_m <= parameters_.widest_m;
  if (thing.mayWalk) {
    Track& track = trackOf(thing, stamp_s, personSpeed_mps);
    follow(track, thing, stamp_s);
    thing.mayWalk =
        stamp_s - std::max(track.stillSince_s, track.thinSince_s) < parameters_.standing_s;
    thing.stands = stamp_s - track.stillSince_s >= parameters_.personStanding_s;
  }
  if (thing.mayWalk) return;
  for (std::size_t i = thing.first; i < thing.first + thing.count; ++i)
    obstacles_.push_back(points_[i]);
}

void SeenPeople::findMovers(double stamp_s) {
  movers_.clear();
  for (const Track& track : tracks_) {
    const bool known = track.lastSeen_s - track.firstSeen_s >= kKnown_s;
    if (!known || track.velocity.norm() < kWalking_mps) continue;
    const double unseen_s = stamp_s - track.lastSeen_s;
    movers_.push_back({track.position + track.velocity * unseen_s, track.velocity});
  }
}

void SeenPeople::findThings(const PlanarScan& scan, const mrpt::math::TPose2D& mapFromRobot,
                            const Place& place) {
  const std::size_t others = things_.size();
  std::size_t first = points_.size(), firstBeam = 0, lastBeam = 0;
  const auto add = [&] {
    if (points_.size() == first) return;
    addThings(first, others, isCovered(scan, firstBeam, -1, parameters_.clusterGap_m),
              isCovered(scan, lastBeam, 1, parameters_.clusterGap_m));
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
void SeenPeople::addThings(std::size_t first, std::size_t others, bool coveredBefore,
                           bool coveredAfter) {
  findStraight(first, points_.size() - 1);
  for (std::size_t i = first; i < points_.size();) {
    if (is_[i] == Is::Straight) obstacles_.push_back(points_[i]);
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

/** Notes the pieces between two hits that are too long and straight for a person: between the ends
 * of a piece all hits are near its chord, else it is halved where one is farthest from it. */
void SeenPeople::findStraight(std::size_t first, std::size_t last) {
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
      if (is_[i] != Is::Mapped) is_[i] = Is::Straight;
    return;
  }
  findStraight(first, farthest);
  findStraight(farthest, last);
}

void SeenPeople::addThing(std::size_t first, std::size_t end, std::size_t others, bool isCovered) {
  TPoint2D sum;
  double width = 0.0;
  for (std::size_t i = first; i < end; ++i) {
    sum += points_[i];
    width = std::max(width, (points_[i] - points_[first]).norm());
  }
  const auto count = end - first;
  Thing thing{first,        count,     sum * (1.0 / static_cast<double>(count)),
              width,        isCovered, std::nullopt,
              std::nullopt, true,      false};
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
  track.firstSeen_s = track.lastSeen_s = track.stillSince_s = track.thinSince_s = stamp_s;
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
  // What is seen of a thing from here and from there has its middle up to half a width away.
  const double moved_m = (thing.middle - track.stoodAt).norm();
  const bool mayBePerson = thing.isCovered || thing.width_m >= parameters_.narrowest_m;
  if (mayBePerson) track.thinSince_s = stamp_s;
  if (moved_m <= parameters_.stillWithin_m + 0.5 * thing.width_m) return;
  track.stoodAt = thing.middle;
  track.stillSince_s = stamp_s;
}

}  // namespace bslnav
