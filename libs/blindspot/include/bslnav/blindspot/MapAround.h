#pragma once

#include <bslnav/blindspot/BitGrid.h>
#include <bslnav/costmap/CostGrid.h>
#include <bslnav/costmap/StaticLayer.h>
#include <mrpt/math/TPose2D.h>

#include <memory>
#include <optional>

namespace bslnav {

/** What the static map shows of the place around the robot. */
class MapAround {
 public:
  /** @param map without one (null) nothing is occupied
   *  @param tolerance_m a hit this near to an occupied cell is the map's */
  MapAround(const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map,
            const StaticParameters& thresholds, double reach_m, double resolution_m,
            double tolerance_m);

  /** Moves to where the robot is. */
  void follow(const mrpt::math::TPose2D& mapFromRobot);

  /** 255 where the map is occupied; else 0. */
  const CostGrid& walls() const { return walls_; }
  const BitGrid& wallBits() const { return wallBits_; }
  /** 255 where a hit is the map's; else 0. */
  const CostGrid& mapped() const { return mapped_; }

 private:
  std::optional<StaticLayer> static_;
  double tolerance_m_;
  CostGrid walls_, mapped_;
  BitGrid wallBits_, nearWallBits_;
  bool started_ = false;
};

}  // namespace bslnav
