#pragma once

#include <bslnav/blindspot/Frontier.h>
#include <bslnav/blindspot/Mover.h>
#include <bslnav/blindspot/SeenThings.h>
#include <mrpt/math/TPose2D.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace bslnav {

/** Something that neither the map nor an obstacle explains, followed from scan to scan. */
struct Track {
  mrpt::math::TPoint2D position, velocity;  ///< of the middle of what is seen; map frame
  double firstSeen_s = 0.0, lastSeen_s = 0.0;
  double stillSince_s = 0.0;
  double thinSince_s = 0.0;  ///< too narrow for a person since then
  double width_m = 0.0;      ///< when it was last seen
  mrpt::math::TPoint2D stoodAt;
  mrpt::math::TPoint2D gait;  ///< its velocity when it last walked; zero: it never did
  /** When it last walked and was as wide as a person; nullopt: never. */
  std::optional<double> walked_s;
  int velocities = 0;  ///< so many were measured
};

/** Tells people from obstacles among what the map does not explain.
 *
 * A thing as wide as a person may walk off at any time, and so may one that something nearer covers
 * in part. What is narrower is an obstacle once it has stood still for a while. Where nobody can
 * have got to unseen it is one at once, and so is a narrow part of what is covered, if all sides
 * are looked at. What is wider or straight is one at once, as walls are without a map, and so is
 * what depth cameras see whole and lower than people. The places of obstacles are remembered until
 * they are seen to be empty, and hits there are explained; what is new beside them is told anew.
 * Things are joined to tracks by nearness, and velocities are smoothed. */
class SeenPeople {
 public:
  using Views = SeenThings::Views;
  using Place = SeenThings::Place;

  explicit SeenPeople(const SeenPeopleParameters& parameters)
      : parameters_(parameters), seen_(parameters) {}

  /** Without lasers and cameras nothing changes.
   *  @param views in the robot frame of `mapFromRobot`
   *  @param place what is known of it besides
   *  @param personSpeed_mps how fast people walk at most */
  void update(const Views& views, double stamp_s, const mrpt::math::TPose2D& mapFromRobot,
              const Place& place, double personSpeed_mps);

  /** The points seen of all who may walk, map frame. */
  const Frontier& frontier() const { return frontier_; }
  /** The nearest point of each who is seen whole, map frame. */
  const std::vector<mrpt::math::TPoint2D>& bodies() const { return bodies_; }
  /** The same of those, too, whom something covers in part. */
  const std::vector<mrpt::math::TPoint2D>& people() const { return people_; }
  /** Those who walk, as fast as they are seen to, and those who have just stopped, as fast as they
   * walked: they may walk on. */
  const Movers& movers() const { return movers_; }
  /** Those who are followed, and what may turn out an obstacle. */
  const std::vector<Track>& tracks() const { return tracks_; }

 private:
  using Thing = SeenThings::Thing;
  enum class Verdict : std::uint8_t { Walks, Stands, Obstacle };

  /** Too narrow for a person, all of it. */
  bool isNarrow(const Thing& thing) const {
    return !thing.isCovered && thing.width_m < parameters_.narrowest_m;
  }
  Verdict verdictOf(const Thing& thing, double stamp_s, const Place& place, double personSpeed_mps);
  bool mayHaveCome(const Thing& thing, double stamp_s, const Place& place,
                   double personSpeed_mps) const;
  void note(const Thing& thing, Verdict verdict, const mrpt::math::TPoint2D& robot);
  void findMovers(double stamp_s);
  Track* trackOf(const Thing& thing, double stamp_s, double personSpeed_mps);
  Track& newTrack(const Thing& thing, double stamp_s);
  void follow(Track& track, const Thing& thing, double stamp_s) const;

  SeenPeopleParameters parameters_;
  SeenThings seen_;
  std::vector<Verdict> verdicts_;                // of its things
  std::vector<mrpt::math::TPoint2D> obstacles_;  // seen now, along them
  std::vector<mrpt::math::TPoint2D> bodies_, people_;
  std::vector<Track> tracks_;
  Frontier frontier_;
  Movers movers_;
  std::vector<mrpt::math::TPoint2D> walkers_;  // who certainly are people
};

}  // namespace bslnav
