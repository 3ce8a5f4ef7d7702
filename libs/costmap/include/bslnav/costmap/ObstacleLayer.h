#pragma once

#include <bslnav/config/ConfigSection.h>
#include <bslnav/costmap/CostGrid.h>
#include <bslnav/costmap/Footprint.h>
#include <bslnav/costmap/PlanarScan.h>
#include <mrpt/math/TPose2D.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bslnav {

/** How scans mark and clear. */
struct ObstacleParameters {
  double obstacleRange_m = 5.0;  ///< returns farther away make no mark
  double raytraceRange_m = 6.0;  ///< beams clear up to here
  bool clearNoReturn = true;     ///< whether a beam without return clears
  bool clearFootprint = true;    ///< whether no obstacle can be where the robot stands

  void describe(ConfigSection& section);
};

/** What the scans say: free where a beam went through, lethal where one ended, unknown elsewhere.
 *
 * A mark stays until a beam passes through it. A beam passes through one cell of each column (each
 * row, if it runs more along y than along x): the one that holds the point where it crosses the
 * column's centre line, from the sensor's column up to, but without, the column of its end. It
 * never clears the cell it ends in.
 *
 * A scan made of a depth image clears everything only from where it sees the floor; nearer, where a
 * low thing may be below its view, it clears a mark only if it would still see what was marked, or
 * if a laser met that, too: the laser's mark tells whether the lower part is still there. */
class ObstacleLayer {
 public:
  /** @param shape gives size, resolution and position; its costs do not matter */
  ObstacleLayer(const ObstacleParameters& parameters, const Footprint& footprint,
                const CostGrid& shape);

  /** Clears along all beams of all scans, then marks the ends of all, then clears the robot's
   * footprint.
   *  @param lasers the layer of lasers in the same place, for scans of depth images; or null
   *  @return the window of the cells that were visited; empty if none */
  CellWindow update(const mrpt::math::TPose2D& mapFromRobot, const std::vector<PlanarScan>& scans,
                    const CostGrid* lasers = nullptr);

  /** Moves the grid by whole cells; new cells are unknown. */
  void shift(int dx, int dy);

  const CostGrid& grid() const { return grid_; }

 private:
  struct Point {
    double x, y;  // in cells, from the grid's lower left corner
  };

  /** The cells that a beam clears: `count` columns from `first` in direction `step`, and in each
   * the row `row`, in fixed point. For a beam that runs more along y, rows and columns change
   * roles.
   */
  struct Line {
    std::int64_t row = 0, slope = 0;
    int first = 0, step = 1, count = 0;
    bool alongX = true;

    Line() = default;
    Line(const Point& from, const Point& to);
    void clip(int majorSize, int minorSize);
    void skip(int cells);
    int sharedWith(const Line& a, const Line& b) const;
  };

  CellWindow trace(const mrpt::math::TPose2D& mapFromRobot, const PlanarScan& scan);
  Line lineWithin(const Point& from, const Point& to) const;
  void clearAlongLines(bool fromOnePoint);
  void clear(const Line& line);
  void clearBelowView(const mrpt::math::TPose2D& mapFromRobot, const PlanarScan& scan);
  CellWindow clearUnder(const mrpt::math::TPose2D& mapFromRobot);

  ObstacleParameters parameters_;
  Footprint footprint_;
  struct Mark {
    int x, y;
    std::uint8_t top;  // height of what was met, in kTopUnit_m
  };

  CostGrid grid_;
  CostGrid tops_;  // of the marks of depth images; empty until there is one
  // Reused every cycle.
  std::vector<Line> lines_;  // of one scan, one a beam
  std::vector<Mark> marks_;  // of all scans
};

}  // namespace bslnav
