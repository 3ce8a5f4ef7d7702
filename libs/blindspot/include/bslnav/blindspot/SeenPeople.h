#pragma once

#include <bslnav/blindspot/Frontier.h>
#include <bslnav/blindspot/Mover.h>
#include <bslnav/blindspot/StandingThings.h>
#include <bslnav/config/ConfigSection.h>
#include <bslnav/costmap/CostGrid.h>
#include <bslnav/costmap/PlanarScan.h>
#include <mrpt/math/TPose2D.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace bslnav {

struct SeenPeopleParameters {
  double clusterGap_m = 0.1;         ///< hits this near are of one thing
  double standingTolerance_m = 0.1;  ///< a hit this near to an obstacle that stands is of it
  double narrowest_m = 0.35, widest_m = 1.5;  ///< of what may be people
  double straight_m = 0.33;                   ///< what is straight over so much is none
  double lowest_m = 0.8;                      ///< what a depth camera sees to be lower is none
  double standing_s = 1.0;        ///< what is narrower and stands so long is an obstacle
  double personStanding_s = 3.0;  ///< a person who stands so long is Standing
  /** The middle of what is seen of a thing that stands stays within this distance and half its
   * width. */
  double stillWithin_m = 0.12;

  void describe(ConfigSection& section);
};

/** Something that neither the map nor an obstacle explains, followed from scan to scan. */
struct Track {
  mrpt::math::TPoint2D position, velocity;  ///< of the middle of what is seen; map frame
  double firstSeen_s = 0.0, lastSeen_s = 0.0;
  double stillSince_s = 0.0;
  double thinSince_s = 0.0;  ///< too narrow for a person since then
  mrpt::math::TPoint2D stoodAt;
};

/** Tells people from obstacles among what the map does not explain.
 *
 * A thing as wide as a person may walk off at any time, and so may one that something nearer covers
 * in part. What is narrower is an obstacle once it has stood still for a while. What is wider or
 * straight is one at once, as walls are without a map, and so is what depth cameras see whole and
 * lower than people. The places of obstacles are remembered until they are seen to be empty, and
 * hits there are explained; what is new beside them is told anew. Hits are joined to things in the
 * order of the beams, things to tracks by nearness, and velocities are smoothed. */
class SeenPeople {
 public:
  /** In one robot frame. Where several see the same thing, the first follows it. */
  struct Views {
    std::vector<const PlanarScan*> lasers;
    std::vector<const PlanarScan*> cameras;    ///< PersonVisibility's
    std::vector<const PlanarScan*> obstacles;  ///< DepthScan's: tell how high things are
  };

  /** What is known of the same place besides. */
  struct Place {
    const CostGrid& mapped;    ///< 255: a hit there is the map's
    StandingThings& standing;  ///< gets the obstacles that are found
  };

  explicit SeenPeople(const SeenPeopleParameters& parameters) : parameters_(parameters) {}

  /** Without lasers and cameras nothing changes.
   *  @param views in the robot frame of `mapFromRobot`
   *  @param place what is known of it besides
   *  @param personSpeed_mps how fast people walk at most */
  void update(const Views& views, double stamp_s, const mrpt::math::TPose2D& mapFromRobot,
              const Place& place, double personSpeed_mps);

  /** The points seen of all who may walk, map frame. */
  const Frontier& frontier() const { return frontier_; }
  /** Those who walk, as fast as they are seen to. */
  const Movers& movers() const { return movers_; }
  /** Those who are followed, and what may turn out an obstacle. */
  const std::vector<Track>& tracks() const { return tracks_; }

 private:
  struct Thing {
    std::size_t first, count;  // of points_
    mrpt::math::TPoint2D middle;
    double width_m;
    bool isCovered;                      // something nearer hides how far it goes on
    std::optional<bool> isLow;           // nullopt: not seen whole
    std::optional<std::size_t> another;  // the same thing in a scan before
    bool mayWalk, stands;
  };
  enum class Is : std::uint8_t { New, Mapped, Standing, Straight };  // what explains a hit
  struct Top {                                                       // of a hit with a height
    mrpt::math::TPoint2D at;
    double height_m;
    bool isWhole;  // the view there reaches above the lowest people
  };

  void findThings(const PlanarScan& scan, const mrpt::math::TPose2D& mapFromRobot,
                  const Place& place);
  void judge(Thing& thing, double stamp_s, double personSpeed_mps);
  void findMovers(double stamp_s);
  void addThings(std::size_t first, std::size_t others, bool coveredBefore, bool coveredAfter);
  void findStraight(std::size_t first, std::size_t last);
  void addThing(std::size_t first, std::size_t end, std::size_t others, bool isCovered);
  std::optional<std::size_t> findAnother(const Thing& thing, std::size_t others) const;
  void findTops(const std::vector<const PlanarScan*>& scans,
                const mrpt::math::TPose2D& mapFromRobot);
  std::optional<bool> isLow(const Thing& thing) const;
  Track& trackOf(const Thing& thing, double stamp_s, double personSpeed_mps);
  void follow(Track& track, const Thing& thing, double stamp_s) const;

  SeenPeopleParameters parameters_;
  std::vector<mrpt::math::TPoint2D> points_;
  std::vector<Is> is_;                           // of points_
  std::vector<mrpt::math::TPoint2D> obstacles_;  // seen now, along them
  std::vector<Top> tops_;
  std::vector<Thing> things_;
  std::vector<Track> tracks_;
  Frontier frontier_;
  Movers movers_;
};

}  // namespace bslnav
