#pragma once

#include <bslnav/blindspot/Frontier.h>
#include <bslnav/blindspot/Mover.h>
#include <bslnav/config/ConfigSection.h>
#include <bslnav/costmap/CostGrid.h>
#include <bslnav/costmap/PlanarScan.h>
#include <mrpt/math/TPose2D.h>

#include <optional>
#include <vector>

namespace bslnav {

struct SeenPeopleParameters {
  double clusterGap_m = 0.1;    ///< hits this near are of one thing
  double mapTolerance_m = 0.1;  ///< a hit this near to an occupied cell of the map is the map's
  double narrowest_m = 0.35, widest_m = 0.9;  ///< of what may be a person
  double lowest_m = 0.8;                      ///< what a depth camera sees to be lower is none
  double standing_s = 1.0;  ///< what is narrower and stands so long is an obstacle
  /** The middle of what is seen of a thing that stands stays within this distance and half its
   * width. */
  double stillWithin_m = 0.12;

  void describe(ConfigSection& section);
};

/** Something that the map does not explain, followed from scan to scan. */
struct Track {
  mrpt::math::TPoint2D position, velocity;  ///< of the middle of what is seen; map frame
  double width_m = 0.0;                     ///< the greatest that was seen of it
  double firstSeen_s = 0.0, lastSeen_s = 0.0;
  double stillSince_s = 0.0;
  mrpt::math::TPoint2D stoodAt;
  bool hasMoved = false;  ///< it walked once
  bool isLow = false;     ///< was seen whole where it stands, and is lower than people
  bool mayWalk = true;    ///< whether it counts as a person
};

/** Tells people from obstacles among what the map does not explain.
 *
 * A thing as wide as a person may walk off at any time, and so may one that something nearer covers
 * in part. What is narrower is an obstacle once it has stood still for a while, unless it was seen
 * to move; what is wider is one at once, as walls are without a map. What depth cameras see whole
 * and lower than people is an obstacle as long as it stands. Hits are joined to things in the order
 * of the beams, things to tracks by nearness, and velocities are smoothed. */
class SeenPeople {
 public:
  /** In one robot frame. Where several see the same thing, the first follows it. */
  struct Views {
    std::vector<const PlanarScan*> lasers;
    std::vector<const PlanarScan*> cameras;    ///< PersonVisibility's
    std::vector<const PlanarScan*> obstacles;  ///< DepthScan's: tell how high things are
  };

  explicit SeenPeople(const SeenPeopleParameters& parameters) : parameters_(parameters) {}

  /** Without lasers and cameras nothing changes.
   *  @param views in the robot frame of `mapFromRobot`
   *  @param solid 255 where the map is occupied, around the robot
   *  @param personSpeed_mps how fast people walk at most */
  void update(const Views& views, double stamp_s, const mrpt::math::TPose2D& mapFromRobot,
              const CostGrid& solid, double personSpeed_mps);

  /** The points seen of all who may walk, map frame. */
  const Frontier& frontier() const { return frontier_; }
  /** Those who walk, as fast as they are seen to. */
  const Movers& movers() const { return movers_; }
  /** All that is followed, people and obstacles. */
  const std::vector<Track>& tracks() const { return tracks_; }

 private:
  struct Thing {
    std::size_t first, count;  // of points_
    mrpt::math::TPoint2D middle;
    double width_m;
    bool isCovered;                      // something nearer hides how far it goes on
    std::optional<bool> isLow;           // nullopt: not seen whole
    std::optional<std::size_t> another;  // the same thing in a scan before
    bool mayWalk;
  };
  struct Top {  // of a hit with a height
    mrpt::math::TPoint2D at;
    double height_m;
    bool isWhole;  // the view there reaches above the lowest people
  };

  void findThings(const PlanarScan& scan, const mrpt::math::TPose2D& mapFromRobot,
                  const CostGrid& solid);
  void findMovers(double stamp_s);
  void addThing(std::size_t first, std::size_t others, bool isCovered);
  std::optional<std::size_t> findAnother(const Thing& thing, std::size_t others) const;
  void findTops(const std::vector<const PlanarScan*>& scans,
                const mrpt::math::TPose2D& mapFromRobot);
  std::optional<bool> isLow(const Thing& thing) const;
  Track& trackOf(const Thing& thing, double stamp_s, double personSpeed_mps);
  void follow(Track& track, const Thing& thing, double stamp_s) const;

  SeenPeopleParameters parameters_;
  std::vector<mrpt::math::TPoint2D> points_;
  std::vector<Top> tops_;
  std::vector<Thing> things_;
  std::vector<Track> tracks_;
  Frontier frontier_;
  Movers movers_;
};

}  // namespace bslnav
