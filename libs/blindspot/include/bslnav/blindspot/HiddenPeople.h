#pragma once

#include <bslnav/blindspot/BitGrid.h>
#include <bslnav/blindspot/Frontier.h>
#include <bslnav/blindspot/MapAround.h>
#include <bslnav/blindspot/ScanView.h>
#include <bslnav/blindspot/SeenArea.h>
#include <bslnav/blindspot/StandingThings.h>
#include <bslnav/config/ConfigSection.h>
#include <bslnav/costmap/CostGrid.h>
#include <mrpt/math/TPose2D.h>

#include <memory>
#include <vector>

namespace bslnav {

struct HiddenPeopleParameters {
  /** What is where no sensor looks. */
  enum class OutsideView : std::uint8_t {
    Free,       ///< nobody comes from there
    Remembered  ///< whoever can have got there since it was seen empty
  };
  double radius_m = 0.25;       ///< r_p: of the smallest disc that a person covers
  double gap_m = 0.4;           ///< nobody comes out between two hits that are nearer to each other
  double mapTolerance_m = 0.1;  ///< a hit this near to an occupied cell of the map is the map's
  double reach_m = 4.0;         ///< farther from the robot nobody matters
  double resolution_m = 0.05;
  double lookMemory_s = 0.5;  ///< a direction counts as looked at for so long
  OutsideView outsideView = OutsideView::Free;

  void describe(ConfigSection& section);
};

/** Where somebody may be whom no sensor sees: a grid around the robot that remembers.
 *
 * A cell is possible if a person who walks at most at some speed can have got there from a place
 * not seen since, and can stand there unseen: a disc of a person's radius fits into what is neither
 * seen now nor solid in the map. The edge of the possible cells towards what is connected with
 * the robot is the frontier: from there, people step out.
 *
 * The grid holds points of people's bodies, not their centres. Its cells are those whose centres
 * are seen or not, so the frontier is exact to 0.71 cells. */
class HiddenPeople {
 public:
  /** @param map static map whose occupied cells hold nobody, or null
   *  @param bodyRadius_m of the robot: where it stands there is nobody else */
  HiddenPeople(const HiddenPeopleParameters& parameters, double bodyRadius_m,
               const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map,
               const StaticParameters& mapThresholds);

  using Scans = std::vector<const PlanarScan*>;

  /** look() and findFrontier() where nobody is seen. */
  void update(const Scans& lasers, double stamp_s, const mrpt::math::TPose2D& mapFromRobot,
              double personSpeed_mps);

  /** Takes in what was seen, and lets people walk on; without scans nothing changes. Obstacles are
   * forgotten where a laser sees past them; cameras, which look over low ones, tell that only where
   * no laser does.
   *  @param lasers in the robot frame of `mapFromRobot`
   *  @param cameras PersonVisibility's, likewise
   *  @param stamp_s when the oldest of them was taken; the state is that of this time
   *  @param personSpeed_mps how fast people walk at most */
  void look(const Scans& lasers, const Scans& cameras, double stamp_s,
            const mrpt::math::TPose2D& mapFromRobot, double personSpeed_mps);

  /** Keeps who fits where they may be, and finds the edge of that.
   *  @param bodies the nearest point of each who is seen whole, map frame: a person's disc begins
   *  there, and nobody else is in it */
  void findFrontier(const std::vector<mrpt::math::TPoint2D>& bodies);

  /** The outermost possible cells towards the robot, map frame. */
  const Frontier& frontier() const { return frontier_; }
  /** Whether people may come into view from where no sensor looks, though they are not possible
   * there. */
  bool hasBlindSide() const { return hasBlindSide_; }
  /** The time that the state is of. */
  double stamp_s() const { return stamp_s_; }
  /** Whether all directions behind the robot were looked at, within the look memory. */
  bool looksBehind() const { return seen_.looksBehind(parameters_.lookMemory_s); }
  /** 255 where somebody may be, in the bodies of those who are seen, too; else 0. */
  const CostGrid& possible() const { return possible_; }
  /** Where somebody unseen can have got to by now, before what is seen now. */
  const BitGrid& reached() const { return reachedBits_; }
  /** 255 where a hit is the map's: near its occupied cells; else 0. */
  const CostGrid& mapped() const { return map_.mapped(); }
  /** 255 where the map is occupied; else 0. */
  const CostGrid& walls() const { return map_.walls(); }
  /** The obstacles that keep people from walking, where they are not in the map. */
  StandingThings& standing() { return standing_; }

 private:
  void lookWith(const Scans& lasers, const Scans& cameras);
  bool isUpToLasers(const mrpt::math::TPoint2D& point) const;
  void grow(double distance_m);
  void takeBodies(const std::vector<mrpt::math::TPoint2D>& bodies);
  void keepWhereSomebodyFits();
  void floodFromRobot();

  HiddenPeopleParameters parameters_;
  double bodyRadius_m_;
  MapAround map_;
  SeenArea seen_;
  CostGrid possible_;
  StandingThings standing_;
  BitGrid possibleBits_, blockedBits_, workBits_;  // blocked: by walls and obstacles
  BitGrid reachedBits_;
  int personRadius_cells_;
  ScanView view_;
  std::vector<ScanView> laserViews_;  // now
  mrpt::math::TPose2D mapFromRobot_;
  double stamp_s_ = 0.0, owed_m_ = 0.0, squaresOwed_ = 0.0;  // growth that is still owed
  bool started_ = false, hasBlindSide_ = false;
  Frontier frontier_;
};

}  // namespace bslnav
