#include <bslnav/blindspot/MapAround.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include "GridAround.h"

namespace bslnav {
namespace {

std::optional<StaticLayer> staticLayer(const mrpt::maps::COccupancyGridMap2D* map,
                                       double resolution_m, const StaticParameters& thresholds) {
  if (!map) return std::nullopt;
  return StaticLayer(*map, resolution_m, thresholds);
}

}  // namespace

MapAround::MapAround(const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map,
                     const StaticParameters& thresholds, double reach_m, double resolution_m,
                     double tolerance_m)
    : static_(staticLayer(map.get(), resolution_m, thresholds)),
      tolerance_m_(tolerance_m),
      walls_(gridAround(reach_m, resolution_m)),
      mapped_(walls_),
      wallBits_(walls_.width(), walls_.height()),
      nearWallBits_(wallBits_) {
  fill(walls_, kNo);
  fill(mapped_, kNo);
}

void MapAround::follow(const mrpt::math::TPose2D& mapFromRobot) {
  recentre(mapped_, mapFromRobot.x, mapFromRobot.y);
  if (!recentre(walls_, mapFromRobot.x, mapFromRobot.y) && started_) return;
  started_ = true;
  if (!static_) {
    fill(walls_, kNo);
    fill(mapped_, kNo);
    return;
  }
  static_->copyTo(walls_, walls_.bounds());
  for (int y = 0; y < walls_.height(); ++y)
    for (int x = 0; x < walls_.width(); ++x)
      walls_.at(x, y) = walls_.at(x, y) == kLethalCost ? kYes : kNo;
  wallBits_.assign(walls_);
  nearWallBits_ = wallBits_;
  const int reach = static_cast<int>(std::ceil(tolerance_m_ / walls_.getResolution()));
  for (int k = 0; k < reach; ++k) nearWallBits_.growSquare();
  nearWallBits_.copyTo(mapped_);
}

}  // namespace bslnav
