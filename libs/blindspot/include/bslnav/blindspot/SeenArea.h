#pragma once

#include <bslnav/blindspot/ScanView.h>
#include <bslnav/costmap/CostGrid.h>
#include <mrpt/math/TPose2D.h>

#include <vector>

namespace bslnav {

/** What the sensors see of the place around the robot in one cycle, as cells: where it is empty,
 * and the surfaces at which the views end; and when they last looked in each direction. */
class SeenArea {
 public:
  SeenArea(double reach_m, double resolution_m);

  /** Forgets what was seen, but not when it was looked at, and moves to where the robot is. */
  void begin(const mrpt::math::TPose2D& mapFromRobot, double stamp_s);

  /** Adds what a sensor sees, from the robot frame of begin().
   *  @param mapped 255 where hits are the static map's, and of no surface besides */
  void add(const ScanView& view, const CostGrid& mapped);

  /** Takes a disc (map frame) for seen to be empty. */
  void takeRoom(const mrpt::math::TPoint2D& centre, double radius_m);

  /** Takes for seen, and sets to 0 in a grid of the same place, what lies where no sensor has
   * looked for a while.
   * @return whether there is such a side */
  bool takeOutsideView(double lookMemory_s, CostGrid& cleared);

  /** 255 where it is seen to be empty; else 0. */
  const CostGrid& empty() const { return empty_; }
  /** 255 where a surface is; else 0. */
  const CostGrid& surfaces() const { return surfaces_; }
  /** Whether all directions behind the robot were looked at for a while, 30° to each side. */
  bool looksBehind(double lookMemory_s) const;

 private:
  void noteLooks(const ScanView& view);
  void cutOut(const ScanView& view);
  void markSurfaces(const ScanView& view, const CostGrid& mapped);

  CostGrid empty_, surfaces_;
  std::vector<int> directions_;     // of the cells of a row
  std::vector<float> squared_;      // their squared distances
  std::vector<double> lookedAt_s_;  // each direction, from right behind on
  mrpt::math::TPose2D mapFromRobot_;
  double stamp_s_ = 0.0;
};

}  // namespace bslnav
