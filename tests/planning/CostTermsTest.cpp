#include <bslnav/planning/CostTerms.h>
#include <gtest/gtest.h>

namespace bslnav {
namespace {

RolloutSetup setupTo(double x_m) {
  RolloutSetup setup;
  setup.horizon_s = 4.0;
  setup.goal = {x_m, 0.0};
  setup.goalTolerance_m = 0.1;
  return setup;
}

TEST(CostTerms, DangerIsTheHighestCostOverTheDivisor) {
  EXPECT_DOUBLE_EQ(dangerTerm(126, kFreeCost, CostWeights{}), 126.0 / 253.0);
}

TEST(CostTerms, DangerOfARolloutToTheGoalIsWhatExceedsTheGoalsOwnCost) {
  EXPECT_DOUBLE_EQ(dangerTerm(200, 150, CostWeights{}), 50.0 / 253.0);
  EXPECT_DOUBLE_EQ(dangerTerm(100, 150, CostWeights{}), 0.0);
}

TEST(CostTerms, VelocityIsOneOverTheSpeedWithAFloor) {
  EXPECT_DOUBLE_EQ(velocityTerm(0.5, CostWeights{}), 2.0);
  EXPECT_DOUBLE_EQ(velocityTerm(0.0, CostWeights{}), 20.0);  // the floor is 0.05 m/s
}

TEST(CostTerms, GoalIsTheDistanceOfTheEndPoint) {
  RolloutOutcome rollout;
  rollout.endPoint = {2.0, 0.0};
  EXPECT_DOUBLE_EQ(goalTerm(rollout, 0.5, setupTo(3.0)), 1.0);
}

TEST(CostTerms, PastTheGoalTheFasterRolloutIsTheCheaperOne) {
  RolloutOutcome rollout;
  rollout.end = RolloutOutcome::End::Goal;
  rollout.endPoint = {1.0, 0.0};
  EXPECT_DOUBLE_EQ(goalTerm(rollout, 0.5, setupTo(1.0)),
                   -1.0);  // 1 m to go, 4 s of 0.5 m/s: 1 m left
  EXPECT_DOUBLE_EQ(goalTerm(rollout, 0.4, setupTo(1.0)), 1.0 - 1.6);
}

TEST(CostTerms, TheCostIsTheirWeightedSum) {
  const CostWeights weights{2.0, 1.0, 10.0, 0.5, 20.0, 253.0, 0.05};
  // 2 * 0.1 + 1 * 3 + 10 * 0.2 + 0.5 * 4
  EXPECT_DOUBLE_EQ(weighted({0.1, 3.0, 0.2, 4.0, 0.5}, weights), 17.2);
}

}  // namespace
}  // namespace bslnav
