#include <bslnav/config/Config.h>
#include <bslnav/planning/GlobalPlanner.h>
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "GlobalPlannerGrids.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using test::centre;
using test::drawn;
using testing::ElementsAre;
using Status = PathResult::Status;

constexpr double kSqrt2 = 577.0 / 408.0;  // the planner's own diagonal

GlobalPlannerParameters exactEnds() {
  GlobalPlannerParameters parameters;
  parameters.startTolerance_m = parameters.goalTolerance_m = 0.0;
  return parameters;
}

TEST(GlobalPlanner, CostsTheOctileDistanceOnAnEmptyGrid) {
  const CostGrid grid(20, 10, 0.5, -3.0, 2.0);
  const auto result = GlobalPlanner().plan(grid, centre(grid, 2, 1), centre(grid, 9, 4));
  ASSERT_EQ(result.status, Status::Found);
  EXPECT_EQ(result.points.size(), 8u);                      // 7 moves: 3 diagonal, 4 straight
  EXPECT_DOUBLE_EQ(result.cost, (3 * kSqrt2 + 4.0) * 0.5);  // cells of 0.5 m
}

TEST(GlobalPlanner, CostsAStepByItsLengthAndTheCellItEnters) {
  GlobalPlannerParameters parameters;
  parameters.costWeight = 3.0;
  const CostGrid grid = drawn({".3."});  // 3 is cost 84
  const auto result = GlobalPlanner(parameters).plan(grid, centre(grid, 0, 0), centre(grid, 2, 0));
  EXPECT_DOUBLE_EQ(result.cost, 0.5 * (1 + 3.0 * 84 / 252) + 0.5 * 1);  // 1.0 m + 0.5 m
}

TEST(GlobalPlanner, GoesAroundCostlyCellsWhenTheWeightSaysSo) {
  const CostGrid grid = drawn({".....",  //
                               ".999.",  //
                               "....."});
  const TPoint2D start = centre(grid, 0, 1), goal = centre(grid, 4, 1);
  GlobalPlannerParameters shortest, careful;
  shortest.costWeight = 0.0;  // straight through: 4 steps
  careful.costWeight = 3.0;   // through 3·4 + 1 = 13, around 2 + 2·√2
  EXPECT_DOUBLE_EQ(GlobalPlanner(shortest).plan(grid, start, goal).cost, 4 * 0.5);
  EXPECT_DOUBLE_EQ(GlobalPlanner(careful).plan(grid, start, goal).cost, (2 + 2 * kSqrt2) * 0.5);
}

TEST(GlobalPlanner, StartsAtACellCentreAndEndsAtTheExactGoal) {
  const CostGrid grid(3, 1, 0.5, -3.0, 2.0);  // centres (−2.75, 2.25), (−2.25, 2.25), (−1.75, 2.25)
  const auto result = GlobalPlanner().plan(grid, {-2.95, 2.4}, {-1.55, 2.05});
  EXPECT_THAT(result.points,
              ElementsAre(TPoint2D{-2.75, 2.25}, TPoint2D{-2.25, 2.25}, TPoint2D{-1.55, 2.05}));
  EXPECT_FALSE(result.goalMoved);
}

TEST(GlobalPlanner, GivesTwoPointsWithinOneCell) {
  const CostGrid grid(1, 1, 0.5, -3.0, 2.0);
  const auto result = GlobalPlanner().plan(grid, {-2.9, 2.1}, {-2.6, 2.4});
  EXPECT_THAT(result.points, ElementsAre(TPoint2D{-2.75, 2.25}, TPoint2D{-2.6, 2.4}));
  EXPECT_EQ(result.cost, 0.0);
}

TEST(GlobalPlanner, GoesAroundACornerInsteadOfCuttingIt) {
  const CostGrid grid = drawn({"..",  //
                               ".#"});
  const auto result = GlobalPlanner(exactEnds()).plan(grid, centre(grid, 0, 0), centre(grid, 1, 1));
  EXPECT_THAT(result.points,
              ElementsAre(centre(grid, 0, 0), centre(grid, 0, 1), centre(grid, 1, 1)));
}

TEST(GlobalPlanner, DoesNotSlipBetweenTwoDiagonalObstacles) {
  const CostGrid grid = drawn({"#.",  //
                               ".#"});
  const auto result = GlobalPlanner(exactEnds()).plan(grid, centre(grid, 0, 0), centre(grid, 1, 1));
  EXPECT_EQ(result.status, Status::NoPath);
  EXPECT_TRUE(result.points.empty());
}

TEST(GlobalPlanner, StaysWithinHalfACellOfTheStraightLine) {
  const CostGrid grid(60, 60, 0.05, 0.0, 0.0);
  GlobalPlanner planner;
  for (int x = 0; x < 60; x += 7)
    for (int y = 0; y < 60; y += 3) {
      const int dx = x - 30, dy = y - 25;
      const auto result = planner.plan(grid, centre(grid, 30, 25), centre(grid, x, y));
      const double longest = std::max(std::abs(dx), std::abs(dy));
      for (const auto& p :
           result.points) {  // offset along the shorter axis = cross product / longer side
        const double cross = (p.x - grid.idx2x(30)) * dy - (p.y - grid.idx2y(25)) * dx;
        EXPECT_LE(std::abs(cross), 0.5001 * longest * 0.05) << "to " << x << ", " << y;
      }
    }
}

TEST(GlobalPlanner, PlansFromAndToInflatedCells) {
  const CostGrid grid = drawn({"9..9"});
  EXPECT_EQ(GlobalPlanner(exactEnds()).plan(grid, centre(grid, 0, 0), centre(grid, 3, 0)).status,
            Status::Found);
}

TEST(GlobalPlanner, MovesABlockedStartToTheNearestFreeCell) {
  const CostGrid grid = drawn({"iii..."});
  GlobalPlannerParameters parameters;
  parameters.startTolerance_m = 1.0;  // from the second cell, the free fourth is 1.0 m away
  const auto result = GlobalPlanner(parameters).plan(grid, centre(grid, 1, 0), centre(grid, 5, 0));
  ASSERT_EQ(result.status, Status::Found);
  EXPECT_EQ(result.points.front(), centre(grid, 3, 0));
  EXPECT_EQ(GlobalPlanner(parameters).plan(grid, centre(grid, 0, 0), centre(grid, 5, 0)).status,
            Status::StartBlocked);
}

TEST(GlobalPlanner, MovesABlockedGoalToTheNearestReachableCell) {
  const CostGrid grid = drawn({"...###.",  //
                               "...###."});
  GlobalPlannerParameters parameters;
  parameters.goalTolerance_m =
      1.6;  // from the sixth cell: the last is nearer but cut off, the third 1.5 m away
  const auto result = GlobalPlanner(parameters).plan(grid, centre(grid, 0, 0), centre(grid, 5, 0));
  ASSERT_EQ(result.status, Status::Found);
  EXPECT_TRUE(result.goalMoved);
  EXPECT_EQ(result.points.back(), centre(grid, 2, 0));
}

TEST(GlobalPlanner, MovesABlockedGoalToWhereThereIsRoom) {
  CostGrid grid(12, 1, 0.1, 0.0, 0.0);
  grid.at(9, 0) = kLethalCost;
  grid.at(8, 0) = 200;  // nearest, but above half the graded cost
  grid.at(7, 0) = 126;
  GlobalPlannerParameters parameters;
  parameters.goalTolerance_m = 0.25;
  const auto result = GlobalPlanner(parameters).plan(grid, centre(grid, 0, 0), centre(grid, 9, 0));
  ASSERT_EQ(result.status, Status::Found);
  EXPECT_NEAR(result.points.back().x, 0.75, 1e-9);
  parameters.goalTolerance_m = 0.15;  // now only the tight cell is within the tolerance
  EXPECT_NEAR(
      GlobalPlanner(parameters).plan(grid, centre(grid, 0, 0), centre(grid, 9, 0)).points.back().x,
      0.85, 1e-9);
}

TEST(GlobalPlanner, TakesTheLowestOfEquallyNearCells) {
  const CostGrid grid = drawn({"...",  //
                               ".#.",  //
                               "..."});
  const auto result = GlobalPlanner().plan(grid, centre(grid, 2, 2), centre(grid, 1, 1));
  ASSERT_TRUE(result.goalMoved);  // four cells are 0.5 m away
  EXPECT_EQ(result.points.back(), centre(grid, 1, 0));
}

TEST(GlobalPlanner, ReportsABlockedGoalWithNothingFreeNear) {
  const CostGrid grid = drawn({"..####"});
  EXPECT_EQ(GlobalPlanner().plan(grid, centre(grid, 0, 0), centre(grid, 4, 0)).status,
            Status::GoalBlocked);
}

TEST(GlobalPlanner, ReportsAnUnreachableGoal) {
  const CostGrid grid =
      drawn({"..##.."});  // the goal's cell is free, but nothing within 0.5 m is reachable
  EXPECT_EQ(GlobalPlanner().plan(grid, centre(grid, 0, 0), centre(grid, 5, 0)).status,
            Status::NoPath);
}

TEST(GlobalPlanner, RefusesWhatIsNotOnTheMap) {
  const CostGrid grid(4, 4, 0.5, -3.0, 2.0);  // x from −3 to −1, y from 2 to 4
  const TPoint2D inside{-2.0, 3.0};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const TPoint2D& outside :
       {TPoint2D{-3.01, 3.0}, {-1.0, 3.0}, {-2.0, 1.99}, {-2.0, 4.0}, {nan, 3.0}, {1e300, 3.0}}) {
    EXPECT_EQ(GlobalPlanner().plan(grid, outside, inside).status, Status::StartOutsideMap);
    EXPECT_EQ(GlobalPlanner().plan(grid, inside, outside).status, Status::GoalOutsideMap);
  }
}

TEST(GlobalPlanner, TakesUnknownCellsOnlyWhenAllowed) {
  const CostGrid grid = drawn({".??."});
  GlobalPlannerParameters parameters = exactEnds();
  EXPECT_EQ(GlobalPlanner(parameters).plan(grid, centre(grid, 0, 0), centre(grid, 3, 0)).status,
            Status::NoPath);
  parameters.allowUnknown = true;
  parameters.costWeight = 2.0;  // unknown costs as the highest graded cell: 1 + 2
  EXPECT_DOUBLE_EQ(
      GlobalPlanner(parameters).plan(grid, centre(grid, 0, 0), centre(grid, 3, 0)).cost,
      (3 + 3 + 1) * 0.5);
}

TEST(GlobalPlanner, ForgetsEarlierSearches) {
  GlobalPlanner planner(exactEnds());
  const CostGrid open = drawn({"....", "...."}), wall = drawn({".#..", ".#.."});
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(planner.plan(open, centre(open, 0, 0), centre(open, 3, 0)).cost, 1.5);
    EXPECT_EQ(planner.plan(wall, centre(wall, 0, 0), centre(wall, 3, 0)).status, Status::NoPath);
  }
}

TEST(GlobalPlanner, DescribesEveryStatusInItsOwnWords) {
  EXPECT_STREQ(describe(Status::Found), "path found");
  EXPECT_STREQ(describe(Status::NoPath), "no path from start to goal");
  EXPECT_STREQ(describe(Status::GoalOutsideMap), "goal is outside the map");
}

TEST(GlobalPlannerParameters, LoadWithUnitsInTheirKeys) {
  GlobalPlannerParameters parameters;
  Config config;
  config.bind("planner", "global planner", parameters);
  config.load({}, {"planner.cost_weight=1.5", "planner.start_tolerance_m=0.1",
                   "planner.goal_tolerance_m=0.2", "planner.allow_unknown=true"});
  EXPECT_EQ(parameters.costWeight, 1.5);
  EXPECT_EQ(parameters.startTolerance_m, 0.1);
  EXPECT_EQ(parameters.goalTolerance_m, 0.2);
  EXPECT_TRUE(parameters.allowUnknown);
}

}  // namespace
}  // namespace bslnav
