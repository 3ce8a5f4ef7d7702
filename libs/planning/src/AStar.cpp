#include <bslnav/planning/AStar.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace bslnav {

// The moves with an odd number are diagonals and lie between their straight components.
const std::array<AStar::Move, 8> AStar::kMoves{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

AStar::AStar(double costWeight) {
  for (std::size_t value = 1; value <= kHighestGradedCost + 1; ++value) {
    const double factor = 1.0 + costWeight * static_cast<double>(value - 1) / kHighestGradedCost;
    stepCost_[0][value] = static_cast<std::uint32_t>(std::lround(kStraight * factor));
    stepCost_[1][value] = static_cast<std::uint32_t>(std::lround(kDiagonal * factor));
  }
}

const AStar::Route& AStar::search(const AStarTerrain& terrain, std::uint32_t start,
                                  std::uint32_t goal) {
  route_.cells.clear();
  route_.cost = 0;
  begin(terrain, start, goal);
  while (!open_.empty()) {
    const auto [key, cell] = open_.pop();
    if (cell == goal) {  // keys never decrease, so that the first arrival is the cheapest
      follow(start, goal);
      break;
    }
    const int x = terrain.x(cell), y = terrain.y(cell);
    const bool overtaken = nodes_[cell].cost + lowerBound(x, y) != key;
    if (!overtaken) expand(terrain, cell, x, y);
  }
  return route_;
}

void AStar::begin(const AStarTerrain& terrain, std::uint32_t start, std::uint32_t goal) {
  if (nodes_.size() != terrain.size() || generation_ == kLastGeneration) {
    nodes_.assign(terrain.size(), Node{});
    generation_ = 0;
  }
  ++generation_;
  for (std::size_t i = 0; i < kMoves.size(); ++i)
    offset_[i] = kMoves[i].dy * terrain.stride() + kMoves[i].dx;
  goalX_ = terrain.x(goal);
  goalY_ = terrain.y(goal);
  lineX_ = goalX_ - terrain.x(start);
  lineY_ = goalY_ - terrain.y(start);

  const std::uint32_t first = lowerBound(terrain.x(start), terrain.y(start));
  // A step away from the goal raises the bound by one free diagonal at most.
  open_.reset(first, stepCost_[1].back() + kDiagonal);
  nodes_[start] = makeNode(0, 0);
  open_.push(first, start);
}

void AStar::expand(const AStarTerrain& terrain, std::uint32_t cell, int x, int y) {
  const std::uint8_t* cells = terrain.cells();
  const std::uint64_t cost = nodes_[cell].cost;
  std::array<Reached, 8> reached;
  std::size_t count = 0;
  std::array<std::uint8_t, 8> value;
  for (std::size_t i = 0; i < 8; ++i) value[i] = cells[neighbour(cell, i)];
  for (std::size_t i = 0; i < 8; ++i) {
    const bool diagonal = i % 2 != 0;
    if (value[i] == 0 || (diagonal && (value[i - 1] == 0 || value[(i + 1) % 8] == 0))) continue;
    const std::uint32_t next = neighbour(cell, i);
    const std::uint64_t nextCost = cost + stepCost_[diagonal ? 1 : 0][value[i]];
    Node& node = nodes_[next];
    if (node.generation == generation_ && node.cost <= nextCost) continue;
    node = makeNode(nextCost, i);
    const int nextX = x + kMoves[i].dx, nextY = y + kMoves[i].dy;
    const Reached entry{offLine(nextX, nextY), nextCost + lowerBound(nextX, nextY), next};
    // Sorted with the nearest to the line last: the queue hands out the last of equals first.
    std::size_t place = count++;
    for (; place > 0 && reached[place - 1].offLine < entry.offLine; --place)
      reached[place] = reached[place - 1];
    reached[place] = entry;
  }
  for (std::size_t i = 0; i < count; ++i) open_.push(reached[i].key, reached[i].cell);
}

void AStar::follow(std::uint32_t start, std::uint32_t goal) {
  route_.cost = nodes_[goal].cost;
  for (std::uint32_t cell = goal; cell != start;) {
    route_.cells.push_back(cell);
    cell -= static_cast<std::uint32_t>(offset_[nodes_[cell].direction]);
  }
  route_.cells.push_back(start);
  std::reverse(route_.cells.begin(), route_.cells.end());
}

/** Cost over free cells only: never above the true cost, and consistent, as no step is cheaper. */
std::uint32_t AStar::lowerBound(int x, int y) const {
  const auto dx = static_cast<std::uint32_t>(std::abs(goalX_ - x)),
             dy = static_cast<std::uint32_t>(std::abs(goalY_ - y));
  return kStraight * std::max(dx, dy) + (kDiagonal - kStraight) * std::min(dx, dy);
}

std::int64_t AStar::offLine(int x, int y) const {
  return std::abs(static_cast<std::int64_t>(goalX_ - x) * lineY_ -
                  static_cast<std::int64_t>(goalY_ - y) * lineX_);
}

}  // namespace bslnav
