#include <bslnav/blindspot/SeenPeople.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

constexpr double kForget_s = 1.0;      // a track not seen for so long ends
constexpr double kSmoothing = 0.5;     // least part of a new velocity in the smoothed one
constexpr double kKnown_s = 0.25;      // before that a velocity is not known
constexpr double kGaitKept = 0.9;      // of the speed of a gait, from scan to scan
constexpr double kWalking_mps = 0.35;  // slower, it may be the view of a thing that changes
constexpr double kPerson_m = 0.6;      // nobody is wider
constexpr double kSlack_m = 0.3;       // of the visible middle between two scans, besides walking

}  // namespace

void SeenPeople::update(const Views& views, double stamp_s, const mrpt::math::TPose2D& mapFromRobot,
                        const Place& place, double personSpeed_mps) {
  if (views.lasers.empty() && views.cameras.empty()) return;
  seen_.find(views, mapFromRobot, place, walkers_);
  frontier_.clear();
  bodies_.clear();
  people_.clear();
  verdicts_.clear();
  obstacles_ = seen_.obstacles();
  for (const Thing& thing : seen_.things()) {
    verdicts_.push_back(thing.another ? verdicts_[*thing.another]
                                      : verdictOf(thing, stamp_s, place, personSpeed_mps));
    note(thing, verdicts_.back(), {mapFromRobot.x, mapFromRobot.y});
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

SeenPeople::Verdict SeenPeople::verdictOf(const Thing& thing, double stamp_s, const Place& place,
                                          double personSpeed_mps) {
  if (thing.isLow.value_or(false)) return Verdict::Obstacle;
  if (thing.width_m > parameters_.widest_m && !thing.isBesideWalker) return Verdict::Obstacle;
  Track* known = trackOf(thing, stamp_s, personSpeed_mps);
  // Of what is covered, a strip may be all that is in view yet.
  const bool isPart = thing.isCovered && place.hasBlindSide;
  if (!known && !isPart && thing.width_m < parameters_.narrowest_m &&
      !mayHaveCome(thing, stamp_s, place, personSpeed_mps))
    return Verdict::Obstacle;
  Track& track = known ? *known : newTrack(thing, stamp_s);
  follow(track, thing, stamp_s);
  const double thinAndStill_s = stamp_s - std::max(track.stillSince_s, track.thinSince_s);
  if (thinAndStill_s >= parameters_.standing_s) return Verdict::Obstacle;
  const bool stands = stamp_s - track.stillSince_s >= parameters_.personStanding_s;
  return stands ? Verdict::Stands : Verdict::Walks;
}

void SeenPeople::note(const Thing& thing, Verdict verdict, const TPoint2D& robot) {
  const auto kind =
      verdict == Verdict::Stands ? FrontierPoint::Kind::Standing : FrontierPoint::Kind::Seen;
  std::size_t nearest = thing.first;
  for (std::size_t i = thing.first; i < thing.first + thing.count; ++i) {
    const TPoint2D& p = seen_.points()[i];
    if (verdict != Verdict::Obstacle)
      frontier_.push_back({static_cast<float>(p.x), static_cast<float>(p.y), kind});
    else if (!thing.another)
      obstacles_.push_back(p);
    if ((p - robot).sqrNorm() < (seen_.points()[nearest] - robot).sqrNorm()) nearest = i;
  }
  if (verdict == Verdict::Obstacle || isNarrow(thing)) return;
  people_.push_back(seen_.points()[nearest]);
  if (!thing.isCovered) bodies_.push_back(seen_.points()[nearest]);
}

/** Whether it is near where somebody unseen can have got to by now, or to whom was seen before.
 * What is hidden of a thing that is covered in part may reach as far as a person does. */
bool SeenPeople::mayHaveCome(const Thing& thing, double stamp_s, const Place& place,
                             double personSpeed_mps) const {
  for (const Track& track : tracks_) {
    const double walked_m = personSpeed_mps * (stamp_s - track.lastSeen_s);
    if ((track.position - thing.middle).norm() <= walked_m + kSlack_m + thing.width_m) return true;
  }
  const double hidden_m = thing.isCovered ? kPerson_m : 0.0;
  return place.isReached(thing.middle, kSlack_m + thing.width_m + hidden_m);
}

void SeenPeople::findMovers(double stamp_s) {
  movers_.clear();
  walkers_.clear();
  for (Track& track : tracks_) {
    const bool known = track.lastSeen_s - track.firstSeen_s >= kKnown_s;
    const bool walks = known && track.velocity.norm() >= kWalking_mps;
    const bool hasMoved = track.stillSince_s > track.firstSeen_s;
    // Who slows down to stop is remembered as fast as before.
    if (walks && hasMoved)
      track.gait =
          track.velocity * std::max(1.0, kGaitKept * track.gait.norm() / track.velocity.norm());
    if (walks && hasMoved && track.width_m >= parameters_.narrowest_m)
      track.walked_s = track.lastSeen_s;
    const double unseen_s = stamp_s - track.lastSeen_s;
    const TPoint2D now = track.position + track.velocity * unseen_s;
    if (track.walked_s && stamp_s - *track.walked_s <= kForget_s) walkers_.push_back(now);
    const bool hasGait = track.gait.norm() > 0.0;
    const bool mayWalkOn = hasGait && stamp_s - track.stillSince_s < parameters_.personStanding_s;
    if (!walks && !mayWalkOn) continue;
    movers_.push_back({now, hasGait ? track.gait : track.velocity});
  }
}

/** The nearest track that is not further on already; null for none. */
Track* SeenPeople::trackOf(const Thing& thing, double stamp_s, double personSpeed_mps) {
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
  return nearest;
}

Track& SeenPeople::newTrack(const Thing& thing, double stamp_s) {
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
    const double part = std::max(kSmoothing, 1.0 / ++track.velocities);  // first, their mean
    track.velocity = track.velocity * (1.0 - part) + measured * part;
  }
  track.position = thing.middle;
  track.width_m = thing.width_m;
  track.lastSeen_s = stamp_s;
  // What is seen of a thing from here and from there has its middle up to half a width away.
  const double moved_m = (thing.middle - track.stoodAt).norm();
  if (!isNarrow(thing)) track.thinSince_s = stamp_s;
  if (moved_m <= parameters_.stillWithin_m + 0.5 * thing.width_m) return;
  track.stoodAt = thing.middle;
  track.stillSince_s = stamp_s;
}

}  // namespace bslnav
