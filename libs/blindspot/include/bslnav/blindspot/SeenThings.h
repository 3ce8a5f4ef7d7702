#pragma once

#include <bslnav/blindspot/BitGrid.h>
#include <bslnav/blindspot/SeenPeopleParameters.h>
#include <bslnav/blindspot/StandingThings.h>
#include <bslnav/costmap/CostGrid.h>
#include <bslnav/costmap/PlanarScan.h>
#include <mrpt/math/TPose2D.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace bslnav {

/** Joins the hits that neither the map nor an obstacle explains to things, in the order of the
 * beams. What is straight over a length is an obstacle, but not beside who walks; what cameras see
 * to be low is said so. */
class SeenThings {
 public:
  /** In one robot frame. Where several see the same thing, the first one's is told apart. */
  struct Views {
    std::vector<const PlanarScan*> lasers;
    std::vector<const PlanarScan*> cameras;    ///< PersonVisibility's
    std::vector<const PlanarScan*> obstacles;  ///< DepthScan's: tell how high things are
  };

  /** What is known of the same place besides. */
  struct Place {
    const CostGrid& mapped;     ///< 255: a hit there is the map's
    const CostGrid& walls;      ///< 255: solid in the map; cells of `mapped`
    StandingThings& standing;   ///< the obstacles that were found, and gets those that are
    const BitGrid& reached;     ///< where somebody unseen can have got to by now; cells of `mapped`
    bool hasBlindSide = false;  ///< and from where no sensor looks

    /** Whether `reached` is within a distance of a point, on a square. Near a known obstacle, what
     * is behind a wall does not count: rather its other side comes into view than somebody through
     * the wall. Elsewhere the wall may have a door by now; one that an obstacle stands beside is
     * not foreseen. */
    bool isReached(const mrpt::math::TPoint2D& p, double distance_m) const;
    /** Whether a wall is on the line between two cells, besides that of which the first one is
     * part: a hit may lie in it. */
    bool isBehindWall(int fromX, int fromY, int toX, int toY) const;
  };

  struct Thing {
    std::size_t first, count;  ///< of points()
    mrpt::math::TPoint2D middle;
    double width_m;
    bool isCovered;                      ///< something nearer hides how far it goes on
    bool isBesideWalker;                 ///< it may be, or hold, somebody who walks
    std::optional<bool> isLow;           ///< nullopt: not seen whole
    std::optional<std::size_t> another;  ///< index of the same thing in a scan before
  };

  explicit SeenThings(const SeenPeopleParameters& parameters) : parameters_(parameters) {}

  /** @param walkers where people walk, map frame */
  void find(const Views& views, const mrpt::math::TPose2D& mapFromRobot, const Place& place,
            const std::vector<mrpt::math::TPoint2D>& walkers);

  const std::vector<Thing>& things() const { return things_; }
  /** Map frame. */
  const std::vector<mrpt::math::TPoint2D>& points() const { return points_; }
  /** Those of what is an obstacle by its form or its place, along it. */
  const std::vector<mrpt::math::TPoint2D>& obstacles() const { return obstacles_; }

 private:
  enum class Is : std::uint8_t { New, Mapped, Standing, Obstacle };  // what explains a hit
  struct Top {                                                       // of a hit with a height
    mrpt::math::TPoint2D at;
    double height_m;
    bool isWhole;  // the view there reaches above the lowest people
    bool isEdge;   // a neighbouring beam does not meet the same: maybe not all its height is met
  };

  void findThings(const PlanarScan& scan, const mrpt::math::TPose2D& mapFromRobot,
                  const Place& place);
  void addThings(std::size_t first, std::size_t others, bool coveredBefore, bool coveredAfter);
  bool isBesideWalker(const mrpt::math::TPoint2D& p) const;
  void findStraight(std::size_t first, std::size_t last);
  void addThing(std::size_t first, std::size_t end, std::size_t others, bool isCovered);
  std::optional<std::size_t> findAnother(const Thing& thing, std::size_t others) const;
  void findTops(const std::vector<const PlanarScan*>& scans,
                const mrpt::math::TPose2D& mapFromRobot);
  std::optional<bool> isLow(const Thing& thing) const;

  SeenPeopleParameters parameters_;
  std::vector<mrpt::math::TPoint2D> points_, obstacles_, walkers_;
  std::vector<Is> is_;  // of points_
  std::vector<Top> tops_;
  std::vector<Thing> things_;
};

}  // namespace bslnav
