#pragma once

#include <bslnav/costmap/Footprint.h>
#include <bslnav/costmap/InflationLayer.h>

#include <array>
#include <vector>

namespace bslnav {

/** Points that cover a footprint densely enough that no lethal cell with its centre inside slips
 * between them.
 *
 * Only the part outside the inscribed circle is covered: a lethal cell inside that circle makes the
 * cell under the robot's centre inscribed (inflation), which the rollout sees by itself. A circular
 * robot needs no cover. */
class FootprintCover {
 public:
  /** @param inflation of the cost map; from the cost under the centre it tells how near an obstacle
   * can be, and so which points need a look */
  FootprintCover(const Footprint& footprint, double resolution_m, const InflationLayer& inflation);

  bool empty() const { return x_.empty(); }
  /** Distance of the farthest point from the robot's centre [m]; 0 when empty. */
  double reach_m() const { return reach_m_; }

  /** Whether the footprint at a pose touches a lethal cell. What is unknown or off the grid is
   * judged under the robot's centre alone, as for a circular robot.
   *  @param gx,gy centre in cells from the grid's lower left corner
   *  @param cosine,sine of the heading */
  bool touches(const CostGrid& grid, float gx, float gy, float cosine, float sine,
               Cost centreCost) const {
    const std::size_t count = nearEnough_[centreCost];
    return count > 0 && touchesAny(grid, gx, gy, cosine, sine, count);
  }

 private:
  bool touchesAny(const CostGrid& grid, float gx, float gy, float cosine, float sine,
                  std::size_t count) const;

  std::vector<float> x_, y_;  // cells, robot frame, the farthest from the centre first
  std::array<std::size_t, 256>
      nearEnough_{};  // by centre cost: how many points may be in an obstacle
  double reach_m_ = 0.0;
};

}  // namespace bslnav
