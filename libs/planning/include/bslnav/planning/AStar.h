#pragma once

#include <bslnav/planning/AStarQueue.h>
#include <bslnav/planning/AStarTerrain.h>

#include <array>
#include <cstdint>
#include <vector>

namespace bslnav {

/** A* (Hart, Nilsson and Raphael 1968) over eight neighbours, with integer costs, cutting no
 * corner.
 *
 * The cost of a step is its length times (1 + costWeight·cost/252) of the cell it enters. Among
 * paths of equal cost the one that keeps to the straight line from start to goal is preferred. Work
 * space is kept between searches. */
class AStar {
 public:
  /** Costs of a straight and a diagonal step over free cells: 577/408 is √2 to two millionths. */
  static constexpr std::uint32_t kStraight = 408, kDiagonal = 577;

  explicit AStar(double costWeight);

  struct Route {
    std::vector<std::uint32_t> cells;  ///< terrain indices, start to goal; empty without a way
    std::uint64_t cost = 0;            ///< in units of 1/kStraight cell
  };
  /** A cheapest route between two passable cells; valid until the next search. */
  const Route& search(const AStarTerrain& terrain, std::uint32_t start, std::uint32_t goal);

 private:
  /** What the search knows of a cell, if `generation` is that of the running search. Forty bits
   * hold the cost of a path through 18 million cells at the greatest accepted cost weight. */
  struct Node {
    std::uint64_t cost : 40, generation : 20, direction : 4;
  };
  struct Move {
    int dx, dy;
  };
  struct Reached {
    std::int64_t offLine;  ///< distance from the straight line, times the line's length
    std::uint64_t key;
    std::uint32_t cell;
  };
  static constexpr std::uint32_t kLastGeneration = (1 << 20) - 1;
  static const std::array<Move, 8> kMoves;

  void begin(const AStarTerrain& terrain, std::uint32_t start, std::uint32_t goal);
  void expand(const AStarTerrain& terrain, std::uint32_t cell, int x, int y);
  void follow(std::uint32_t start, std::uint32_t goal);
  Node makeNode(std::uint64_t cost, std::size_t direction) const {
    return {cost & 0xFFFFFFFFFF, generation_ & kLastGeneration, direction & 7};
  }
  std::uint32_t lowerBound(int x, int y) const;
  std::int64_t offLine(int x, int y) const;
  std::uint32_t neighbour(std::uint32_t cell, std::size_t direction) const {
    return cell + static_cast<std::uint32_t>(offset_[direction]);  // negative ones wrap around
  }

  /** [diagonal][terrain value] */
  std::array<std::array<std::uint32_t, kHighestGradedCost + 2>, 2> stepCost_{};
  std::array<int, 8> offset_{};  ///< index difference of each move
  std::vector<Node> nodes_;
  AStarQueue open_;
  Route route_;
  std::uint32_t generation_ = 0;
  int goalX_ = 0, goalY_ = 0, lineX_ = 0, lineY_ = 0;
};

}  // namespace bslnav
