#pragma once

#include <bslnav/config/ConfigSection.h>
#include <bslnav/costmap/CostGrid.h>

namespace mrpt::maps {
class COccupancyGridMap2D;
}

namespace bslnav {

/** How sure the map must be; between the two thresholds a cell is unknown. */
struct StaticParameters {
  double occupiedThreshold = 0.6;  ///< probability of being occupied, from here on lethal
  double freeThreshold = 0.4;      ///< probability of being occupied, up to here free

  void describe(ConfigSection& section);
  /** @throws Error unless the free threshold is below the occupied one. */
  void check() const;
};

/** What the map says, as free, lethal or unknown costs. */
class StaticLayer {
 public:
  /** Converts the whole map once.
   *
   * The cells need not be those of the map: a cost cell takes the worst map cell that it overlaps,
   * and occupied is worse than unknown, which is worse than free. Outside the map all is unknown.
   * Overlaps below a thousandth of a map cell are rounding. */
  StaticLayer(const mrpt::maps::COccupancyGridMap2D& map, double resolution_m,
              const StaticParameters& parameters);

  /** The whole map, on cells aligned to multiples of the resolution. */
  const CostGrid& grid() const { return grid_; }

  /** Writes what the map says about the cells in `window` of `out`, a grid of the same resolution;
   * unknown off the map. */
  void copyTo(CostGrid& out, const CellWindow& window) const;

 private:
  CostGrid grid_;
};

}  // namespace bslnav
