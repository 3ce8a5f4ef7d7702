#pragma once

#include <bslnav/costmap/BlindSpotLayer.h>
#include <bslnav/costmap/InflationLayer.h>
#include <bslnav/costmap/ObstacleLayer.h>
#include <bslnav/costmap/StaticLayer.h>

#include <memory>
#include <optional>
#include <vector>

namespace bslnav {

/** Size of the cost map and what its layers do; one INI section. */
struct CostmapParameters {
  double resolution_m = 0.05;
  double width_m = 10.0;   ///< of a rolling cost map
  double height_m = 10.0;  ///< of a rolling cost map
  StaticParameters map;
  ObstacleParameters obstacles;
  InflationParameters inflation;

  void describe(ConfigSection& section);
  /** @throws Error on values that do not go together. */
  void check() const;
};

/** What a cost map covers. */
enum class Extent {
  Rolling,  ///< width × height around the robot, moved by whole cells
  WholeMap  ///< the static map
};

/** The layered cost map: static → obstacle → inflation → blind spots, each at least the one before.
 *
 * With a map, cells are unknown off the map; cells that the map does not know become free where a
 * beam went through, while what the map calls occupied stays lethal. Without a map, cells are free
 * until marked. Each update recomputes only the window of what changed, grown by the inflation
 * radius. Updates allocate nothing once scans and zones have had their largest number. */
class LayeredCostmap {
 public:
  /** @param map may be null for a rolling cost map; it is read once
   *  @throws Error on parameters that do not go together, or Extent::WholeMap without a map */
  LayeredCostmap(const CostmapParameters& parameters, const Footprint& footprint,
                 const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map, Extent extent);

  /** Takes in one cycle: moves with the robot (Rolling), clears and marks, inflates, and adds the
   * danger zones in place of the last cycle's.
   * @param mapFromRobot finite; may lie off the map
   * @param depthScans made of depth images; what lasers see does not clear what they marked, as a
   * laser looks below a table top, nor the other way round */
  void update(const mrpt::math::TPose2D& mapFromRobot, const std::vector<PlanarScan>& scans,
              const std::vector<DangerZone>& zones, const std::vector<PlanarScan>& depthScans = {});

  /** All layers. */
  const CostGrid& costs() const { return costs_; }
  /** Static, obstacle and inflation layer without blind spots: what the global planner plans on. */
  const CostGrid& costsWithoutBlindSpots() const { return inflated_; }
  double inscribedRadius_m() const { return inscribedRadius_m_; }

 private:
  CellWindow recentre(const mrpt::math::TPose2D& mapFromRobot);
  CellWindow merge(const CellWindow& window);
  void inflate(const CellWindow& changed);

  Extent extent_;
  double inscribedRadius_m_;
  std::optional<StaticLayer> static_;
  CostGrid background_;  // the static layer where this cost map is
  ObstacleLayer obstacles_, depthObstacles_;
  CostGrid merged_;         // static and obstacle layers
  bool usesDepth_ = false;  // since the first depth scan
  std::vector<Cost> mergedRow_;
  InflationLayer inflation_;
  CostGrid inflated_;
  CostGrid costs_;
  CellWindow zones_;  // where costs_ and inflated_ may differ
};

}  // namespace bslnav
