#pragma once

#include <bslnav/costmap/CostGrid.h>

#include <cstdint>
#include <vector>

namespace bslnav {

/** The cells of a cost grid that a search may enter, framed by blocked cells so that no neighbour
 * is out of bounds.
 *
 * A cell's index counts the frame: index(x, y) = (y + 1)·stride() + x + 1. Buffers are kept between
 * assignments. */
class AStarTerrain {
 public:
  /** Cells at kInscribedCost and above are blocked. With `allowUnknown`, unknown cells are passable
   * at the highest graded cost: a robot that may cross what it does not know still prefers what it
   * knows. */
  void assign(const CostGrid& grid, bool allowUnknown);

  int stride() const { return stride_; }
  std::size_t size() const { return cells_.size(); }
  std::uint32_t index(int x, int y) const {
    return static_cast<std::uint32_t>(y + 1) * static_cast<std::uint32_t>(stride_) +
           static_cast<std::uint32_t>(x + 1);
  }
  int x(std::uint32_t index) const {
    return static_cast<int>(index % static_cast<std::uint32_t>(stride_)) - 1;
  }
  int y(std::uint32_t index) const {
    return static_cast<int>(index / static_cast<std::uint32_t>(stride_)) - 1;
  }

  /** 0 for a blocked cell, else its cost + 1, at most 253. */
  const std::uint8_t* cells() const { return cells_.data(); }
  bool passable(std::uint32_t index) const { return cells_[index] != 0; }

  /** Number of the connected region a passable cell belongs to; 0 for blocked cells.
   *
   * Regions are 4-connected. A diagonal move that may not cut corners has two 4-connected detours,
   * so that 8-connected moves join no regions that 4-connected moves do not. */
  int region(std::uint32_t index) const { return regions_[index]; }

 private:
  std::vector<std::uint8_t> cells_;
  std::vector<std::int32_t> regions_;
  int stride_ = 0;
};

}  // namespace bslnav
