#include <bslnav/planning/GlobalPlanner.h>
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "GlobalPlannerGrids.h"

namespace bslnav {
namespace {

using test::centre;
using test::costsFrom;
using test::kUnreached;
using Status = PathResult::Status;

struct Problem {
  CostGrid grid;
  GlobalPlannerParameters parameters;  // with exact ends
  int startX, startY, goalX, goalY;
};

/** Up to 15 × 15 cells, about a quarter of them blocked; start and goal may be anywhere. */
Problem anyProblem() {
  const auto below = [](int end) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, end));
  };
  const int width = 1 + below(15), height = 1 + below(15);
  const auto cells = *rc::gen::container<std::vector<Cost>>(
      static_cast<std::size_t>(width * height),
      rc::gen::weightedOneOf<Cost>(
          {{9, rc::gen::just(kFreeCost)},
           {6, rc::gen::resize(rc::kNominalSize, rc::gen::inRange<Cost>(1, kInscribedCost))},
           {4, rc::gen::element(kInscribedCost, kLethalCost)},
           {1, rc::gen::just(kUnknownCost)}}));
  Problem problem{CostGrid(width, height, 0.5, -3.0, 2.0), {}, 0, 0, 0, 0};
  std::copy(cells.begin(), cells.end(), problem.grid.row(0));
  problem.parameters.startTolerance_m = problem.parameters.goalTolerance_m = 0.0;
  problem.parameters.costWeight = *rc::gen::element(0.0, 0.7, 3.0, 20.0);
  problem.parameters.allowUnknown = *rc::gen::arbitrary<bool>();
  problem.startX = below(width);
  problem.startY = below(height);
  problem.goalX = below(width);
  problem.goalY = below(height);
  return problem;
}

PathResult solve(GlobalPlanner& planner, const Problem& p) {
  return planner.plan(p.grid, centre(p.grid, p.startX, p.startY), centre(p.grid, p.goalX, p.goalY));
}

PathResult solve(const Problem& p) {
  GlobalPlanner planner(p.parameters);
  return solve(planner, p);
}

bool passable(const Problem& p, int x, int y) {
  const Cost cost = p.grid.at(x, y);
  return cost < kInscribedCost || (cost == kUnknownCost && p.parameters.allowUnknown);
}

std::int64_t dijkstra(const Problem& p) {
  const auto costs = costsFrom(p.grid, p.startX, p.startY, p.parameters);
  return costs[static_cast<std::size_t>(p.goalY * p.grid.width() + p.goalX)];
}

RC_GTEST_PROP(GlobalPlannerLaw, CostIsThatOfDijkstra, ()) {
  const Problem problem = anyProblem();
  const std::int64_t expected = dijkstra(problem);
  const PathResult result = solve(problem);
  RC_CLASSIFY(expected > 0, "reached");
  RC_ASSERT((result.status == Status::Found) == (expected != kUnreached));
  if (expected != kUnreached) RC_ASSERT(std::llround(result.cost / 0.5 * 408) == expected);
}

RC_GTEST_PROP(GlobalPlannerLaw, APathIsPassableAdjacentAndCutsNoCorner, ()) {
  const Problem problem = anyProblem();
  const PathResult result = solve(problem);
  RC_PRE(result.status == Status::Found);
  RC_ASSERT(result.points.size() >= 2u);
  double cost = 0.0;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    const int x = problem.grid.cellX(result.points[i].x),
              y = problem.grid.cellY(result.points[i].y);
    RC_ASSERT(passable(problem, x, y));
    if (i == 0) continue;
    const int px = problem.grid.cellX(result.points[i - 1].x),
              py = problem.grid.cellY(result.points[i - 1].y);
    RC_ASSERT(std::max(std::abs(x - px), std::abs(y - py)) <= 1);
    RC_ASSERT((passable(problem, x, py) && passable(problem, px, y)));
    const double graded = std::min(problem.grid.at(x, y), kHighestGradedCost);
    cost +=
        0.5 * std::hypot(x - px, y - py) * (1.0 + problem.parameters.costWeight * graded / 252.0);
  }
  RC_ASSERT(std::abs(cost - result.cost) <= 0.002 * cost);  // rounding: half of 1/408 a step
}

RC_GTEST_PROP(GlobalPlannerLaw, CostlierCellsNeverMakeAPathCheaper, ()) {
  Problem problem = anyProblem();
  const PathResult before = solve(problem);
  RC_PRE(before.points.size() > 2u);
  const auto on = *rc::gen::elementOf(before.points);  // elsewhere it would hardly matter
  Cost& cost = problem.grid.at(problem.grid.cellX(on.x), problem.grid.cellY(on.y));
  RC_PRE(cost < kHighestGradedCost);
  cost = *rc::gen::element<Cost>(static_cast<Cost>(cost + 1), kHighestGradedCost, kInscribedCost,
                                 kLethalCost);
  const PathResult after = solve(problem);
  RC_CLASSIFY(after.cost > before.cost, "costlier");
  if (after.status == Status::Found) RC_ASSERT(after.cost >= before.cost);
}

RC_GTEST_PROP(GlobalPlannerLaw, MovesAlongEightNeighboursReachWhatIsFourConnected, ()) {
  const Problem problem = anyProblem();
  AStarTerrain terrain;
  terrain.assign(problem.grid, problem.parameters.allowUnknown);
  const int region = terrain.region(terrain.index(problem.startX, problem.startY));
  const auto costs = costsFrom(problem.grid, problem.startX, problem.startY, problem.parameters);
  for (int y = 0; y < problem.grid.height(); ++y)
    for (int x = 0; x < problem.grid.width(); ++x) {
      const bool reached =
          costs[static_cast<std::size_t>(y * problem.grid.width() + x)] != kUnreached;
      RC_ASSERT((region != 0 && terrain.region(terrain.index(x, y)) == region) == reached);
    }
}

RC_GTEST_PROP(GlobalPlannerLaw, AMovedGoalIsTheNearestReachableCellWithinTheToleranceRoomyOnesFirst,
              ()) {
  Problem problem = anyProblem();
  problem.parameters.goalTolerance_m = *rc::gen::element(0.5, 0.8, 2.0);
  problem.grid.at(problem.goalX, problem.goalY) = kLethalCost;
  const PathResult result = solve(problem);
  RC_PRE(result.status == Status::Found && result.goalMoved);
  const auto goal = centre(problem.grid, problem.goalX, problem.goalY);
  const auto rank = [&](const mrpt::math::TPoint2D& p) {
    return std::make_pair(problem.grid.costAt(p.x, p.y) > 126, (p - goal).norm());
  };
  const auto chosen = rank(result.points.back());
  const double tolerance_m = problem.parameters.goalTolerance_m;
  RC_ASSERT(chosen.second <= tolerance_m);
  const auto costs = costsFrom(problem.grid, problem.startX, problem.startY, problem.parameters);
  for (int y = 0; y < problem.grid.height(); ++y)
    for (int x = 0; x < problem.grid.width(); ++x) {
      const auto other = rank(centre(problem.grid, x, y));
      const bool reached =
          costs[static_cast<std::size_t>(y * problem.grid.width() + x)] != kUnreached;
      if (reached && other.second <= tolerance_m) RC_ASSERT(other >= chosen);
    }
}

RC_GTEST_PROP(GlobalPlannerLaw, AUsedPlannerAnswersAsANewOne, ()) {
  Problem first = anyProblem(), second = anyProblem();
  GlobalPlanner planner(second.parameters);
  solve(planner, first);
  const PathResult again = solve(planner, second), fresh = solve(second);
  RC_ASSERT(again.status == fresh.status);
  RC_ASSERT(again.points == fresh.points);
}

}  // namespace
}  // namespace bslnav
