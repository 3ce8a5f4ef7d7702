#include <bslnav/planning/GlobalPlanner.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

// A robot stops badly at the very edge of an obstacle's inscribed cells: a goal that has to be
// moved goes to a cell of at most half the graded cost, if there is one within the tolerance.
constexpr Cost kRoomyCost = kHighestGradedCost / 2;

using mrpt::math::TPoint2D;
using Status = PathResult::Status;

/** False for NaN, and for what rounding at the far edge puts into a cell that is not there. */
bool covers(const CostGrid& grid, const TPoint2D& p) {
  return p.x >= grid.getXMin() && p.x < grid.getXMax() && p.y >= grid.getYMin() &&
         p.y < grid.getYMax() && grid.bounds().contains(grid.cellX(p.x), grid.cellY(p.y));
}

PathResult failed(Status status) {
  PathResult result;
  result.status = status;
  return result;
}

}  // namespace

void GlobalPlannerParameters::describe(ConfigSection& section) {
  section.number("cost_weight", costWeight, {0.0, 100.0}, "",
                 "a step costs length * (1 + cost_weight * cost/252): 0 for the shortest path, "
                 "more to keep clear of obstacles");
  section.number("start_tolerance_m", startTolerance_m, kNonNegative, "m",
                 "how far a blocked start may be moved");
  section.number("goal_tolerance_m", goalTolerance_m, kNonNegative, "m",
                 "how far a blocked or unreachable goal may be moved");
  section.flag("allow_unknown", allowUnknown,
               "plan through unknown cells, at the highest graded cost");
}

const char* describe(PathResult::Status status) {
  switch (status) {
    case Status::Found:
      return "path found";
    case Status::NoPath:
      return "no path from start to goal";
    case Status::StartBlocked:
      return "start is blocked and no free cell lies within the start tolerance";
    case Status::GoalBlocked:
      return "goal is blocked and no free cell lies within the goal tolerance";
    case Status::StartOutsideMap:
      return "start is outside the map";
    case Status::GoalOutsideMap:
      return "goal is outside the map";
  }
  return "unknown status";
}

PathResult GlobalPlanner::plan(const CostGrid& grid, const TPoint2D& start, const TPoint2D& goal) {
  if (!covers(grid, start)) return failed(Status::StartOutsideMap);
  if (!covers(grid, goal)) return failed(Status::GoalOutsideMap);
  terrain_.assign(grid, parameters_.allowUnknown);

  const auto from = nearest(grid, start, parameters_.startTolerance_m, 0, kUnknownCost);
  if (!from) return failed(Status::StartBlocked);
  const auto to =
      nearest(grid, goal, parameters_.goalTolerance_m, terrain_.region(*from), kRoomyCost);
  if (!to) {
    const bool blocked = !nearest(grid, goal, parameters_.goalTolerance_m, 0, kRoomyCost);
    return failed(blocked ? Status::GoalBlocked : Status::NoPath);
  }

  const AStar::Route& route = astar_.search(terrain_, *from, *to);
  PathResult result;
  result.status = Status::Found;
  result.cost = static_cast<double>(route.cost) * grid.getResolution() / AStar::kStraight;
  result.goalMoved = *to != terrain_.index(grid.cellX(goal.x), grid.cellY(goal.y));
  result.points.reserve(route.cells.size() + 1);
  for (const auto cell : route.cells) result.points.push_back(centre(grid, cell));
  if (result.points.size() > 1) result.points.pop_back();
  result.points.push_back(result.goalMoved ? centre(grid, *to) : goal);
  return result;
}

std::optional<std::uint32_t> GlobalPlanner::nearest(const CostGrid& grid, const TPoint2D& p,
                                                    double tolerance_m, int region,
                                                    Cost roomy) const {
  const auto accepted = [&](std::uint32_t cell) {
    return terrain_.passable(cell) && (region == 0 || terrain_.region(cell) == region);
  };
  const int x0 = grid.cellX(p.x), y0 = grid.cellY(p.y);
  if (accepted(terrain_.index(x0, y0))) return terrain_.index(x0, y0);

  const double farthest = std::max(grid.width(), grid.height());
  const int reach =
      static_cast<int>(std::min(std::ceil(tolerance_m / grid.getResolution()), farthest));
  const CellWindow window =
      CellWindow{x0, y0, x0 + 1, y0 + 1}.grown(reach).intersected(grid.bounds());
  std::optional<std::uint32_t> best;
  std::pair<bool, double> bestRank{true, tolerance_m};  // tight, then distance
  for (int y = window.y0; y < window.y1; ++y)
    for (int x = window.x0; x < window.x1; ++x) {
      const std::uint32_t cell = terrain_.index(x, y);
      if (!accepted(cell)) continue;
      const double distance_m = (centre(grid, cell) - p).norm();
      const std::pair<bool, double> rank{grid.at(x, y) > roomy, distance_m};
      if (distance_m <= tolerance_m && (rank < bestRank || (!best && rank == bestRank))) {
        best = cell;
        bestRank = rank;
      }
    }
  return best;
}

TPoint2D GlobalPlanner::centre(const CostGrid& grid, std::uint32_t cell) const {
  return {grid.idx2x(terrain_.x(cell)), grid.idx2y(terrain_.y(cell))};
}

}  // namespace bslnav
