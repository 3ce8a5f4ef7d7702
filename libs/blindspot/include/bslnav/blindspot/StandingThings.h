#pragma once

#include <bslnav/costmap/CostGrid.h>
#include <mrpt/math/TPoint2D.h>

#include <functional>

namespace bslnav {

/** Where obstacles stand that the map does not show: a grid around the robot that remembers places,
 * not things. So whoever moves is new where he comes to, whatever he was taken for before. */
class StandingThings {
 public:
  /** Moves over the map to where another grid is, whose size the first call takes over. */
  void follow(const CostGrid& place);

  /** Forgets what stood where it is seen to be empty now, and all around it, too.
   *  @param empty 255 where nothing stands; the same place as in follow()
   *  @param isAsked whether `empty` counts for a point, map frame; null: everywhere */
  void forget(const CostGrid& empty,
              const std::function<bool(const mrpt::math::TPoint2D&)>& isAsked = nullptr);

  /** Notes that an obstacle reaches from one point to another. */
  void add(const mrpt::math::TPoint2D& from, const mrpt::math::TPoint2D& to);

  /** Whether an obstacle stands within a distance of a point, on a square. */
  bool isNear(const mrpt::math::TPoint2D& point, double distance_m) const;

  /** 255 where an obstacle stands, else 0. */
  const CostGrid& cells() const { return stands_; }

 private:
  CostGrid stands_;
};

}  // namespace bslnav
