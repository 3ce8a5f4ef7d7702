#pragma once

#include <bslnav/costmap/CellWindow.h>
#include <bslnav/costmap/CostValues.h>
#include <mrpt/containers/CDynamicGrid.h>

#include <cmath>

namespace bslnav {

/** A grid of costs in the map frame: MRPT's dynamic grid with row access and indices that are right
 * left of the origin.
 *
 * Row-major, cell (0, 0) at the lower left corner (x_min, y_min); x to the right, y up; metres. */
class CostGrid : public mrpt::containers::CDynamicGrid<Cost> {
 public:
  /** @param width,height cells
   *  @param xMin_m,yMin_m lower left corner; rounded to a multiple of the resolution, so that grids
   * of one resolution align */
  CostGrid(int width, int height, double resolution_m, double xMin_m, double yMin_m,
           Cost fill = kFreeCost) {
    const double x0 = std::round(xMin_m / resolution_m), y0 = std::round(yMin_m / resolution_m);
    setSize(x0 * resolution_m, (x0 + width) * resolution_m, y0 * resolution_m,
            (y0 + height) * resolution_m, resolution_m, &fill);
  }
  CostGrid() : CostGrid(0, 0, 0.05, 0.0, 0.0) {}

  int width() const { return static_cast<int>(m_size_x); }
  int height() const { return static_cast<int>(m_size_y); }
  CellWindow bounds() const { return {0, 0, width(), height()}; }

  /** First cell of row y, 0 <= y < height(); rows follow each other without gaps. */
  Cost* row(int y) { return m_map.data() + static_cast<std::size_t>(y) * m_size_x; }
  const Cost* row(int y) const { return m_map.data() + static_cast<std::size_t>(y) * m_size_x; }
  Cost& at(int x, int y) { return row(y)[x]; }
  Cost at(int x, int y) const { return row(y)[x]; }

  /** Cell index of a coordinate; may lie outside the grid (CDynamicGrid::x2idx rounds -0.5 to 0,
   * this does not). */
  int cellX(double x_m) const {
    return static_cast<int>(std::floor((x_m - m_x_min) / m_resolution));
  }
  int cellY(double y_m) const {
    return static_cast<int>(std::floor((y_m - m_y_min) / m_resolution));
  }
  /** Cost at a position; unknown outside the grid. */
  Cost costAt(double x_m, double y_m) const {
    const int x = cellX(x_m), y = cellY(y_m);
    return bounds().contains(x, y) ? at(x, y) : kUnknownCost;
  }

  /** Moves the grid by whole cells over the map: what both positions cover is kept, new cells get
   * `fill`. No allocation. */
  void shift(int dx, int dy, Cost fill);
};

}  // namespace bslnav
