#include <bslnav/planning/Rollout.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "DwaGenerators.h"

namespace bslnav {
namespace {

using mrpt::math::TPose2D;
using test::any;
using test::anySetup;
using test::onArc;
using End = RolloutOutcome::End;

constexpr double kCell_m = 0.05;

FootprintCover circle() { return FootprintCover({}, kCell_m, test::noInflation()); }

RC_GTEST_PROP(RolloutLaw, EndsWhereTheArcEnds, ()) {
  const CostGrid grid(400, 400, kCell_m, -10.0, -10.0);
  const RolloutSetup setup = anySetup();
  const double v = any(-1.0, 1.0), w = *rc::gen::element(0.0, 1e-9, any(-2.0, 2.0));
  const RolloutOutcome outcome = rollOut(v, w, setup, grid, circle());
  const TPose2D expected = onArc(setup.start, v, w, setup.horizon_s);
  RC_ASSERT(outcome.end == End::Horizon);
  RC_ASSERT(std::hypot(outcome.endPoint.x - expected.x, outcome.endPoint.y - expected.y) <
            3e-4);  // single precision, up to 120 steps
}

/** The same rollout, step by step with sine and cosine. */
struct Plain {
  RolloutOutcome outcome;
  bool ambiguous = false;  // so near to a cell's border that rounding decides

  Plain(double v, double w, const RolloutSetup& setup, const CostGrid& grid) {
    const double cells = std::abs(v) * setup.horizon_s / kCell_m;
    const int n =
        static_cast<int>(std::ceil(std::max({1.0, setup.horizon_s / setup.step_s, cells}) - 1e-9));
    while (outcome.steps < n && !outcome.blocked()) {
      const TPose2D pose = onArc(setup.start, v, w, ++outcome.steps * setup.horizon_s / n);
      for (const double p :
           {(pose.x - grid.getXMin()) / kCell_m, (pose.y - grid.getYMin()) / kCell_m})
        ambiguous = ambiguous || std::abs(p - std::round(p)) < 1e-3;
      const Cost cost = grid.costAt(pose.x, pose.y);
      if (cost == kUnknownCost) {
        if (!setup.allowUnknown) outcome.end = End::Unknown;
      } else if (cost >= kInscribedCost) {
        outcome.end = End::Obstacle;
      } else {
        outcome.highestCost = std::max(outcome.highestCost, cost);
      }
    }
  }
};

RC_GTEST_PROP(RolloutLaw, IsThatOfThePlainOne, ()) {
  CostGrid grid = test::inflated(test::scattered(25), InflationLayer({0.4, 5.0}, 0.12, kCell_m));
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
    const int x0 = *rc::gen::inRange(0, 115), y0 = *rc::gen::inRange(0, 115);
    for (int k = 0; k < 25; ++k) grid.at(x0 + k % 5, y0 + k / 5) = kUnknownCost;
  }
  const RolloutSetup setup = anySetup();
  const double v = any(0.0, 1.5), w = any(-1.5, 1.5);
  const Plain plain(v, w, setup, grid);
  RC_PRE(!plain.ambiguous);
  const RolloutOutcome outcome = rollOut(v, w, setup, grid, circle());
  RC_CLASSIFY(outcome.blocked(), "blocked");
  RC_ASSERT(outcome.end == plain.outcome.end);
  RC_ASSERT(outcome.steps == plain.outcome.steps);
  RC_ASSERT(outcome.highestCost == plain.outcome.highestCost);
}

TEST(Rollout, EndsWhereItIsNearestToAGoalThatItPasses) {
  const CostGrid grid(200, 200, kCell_m, -5.0, -5.0);
  RolloutSetup setup;
  setup.goal = {1.017, 0.05};
  setup.goalTolerance_m = 0.1;
  const RolloutOutcome outcome = rollOut(0.5, 0.0, setup, grid, circle());
  EXPECT_EQ(outcome.end, End::Goal);
  EXPECT_NEAR(outcome.endPoint.x, 1.017, 1e-5);
  EXPECT_NEAR(outcome.endPoint.y, 0.0, 1e-5);
  EXPECT_EQ(outcome.steps, 21);  // of 5 cm
}

TEST(Rollout, GoesOnPastAGoalOutsideTheTolerance) {
  const CostGrid grid(200, 200, kCell_m, -5.0, -5.0);
  RolloutSetup setup;
  setup.goal = {1.0, 0.11};
  setup.goalTolerance_m = 0.1;
  EXPECT_EQ(rollOut(0.5, 0.0, setup, grid, circle()).end, End::Horizon);
  setup.goal = {2.05, 0.0};  // 5 cm beyond the end of the horizon, 0.5 m/s · 4 s
  EXPECT_EQ(rollOut(0.5, 0.0, setup, grid, circle()).end, End::Goal);
}

TEST(Rollout, StandingAtTheGoalIsAtTheGoal) {
  const CostGrid grid(200, 200, kCell_m, -5.0, -5.0);
  RolloutSetup setup;
  setup.goal = {0.05, 0.0};
  setup.goalTolerance_m = 0.1;
  EXPECT_EQ(rollOut(0.0, 0.0, setup, grid, circle()).end, End::Goal);
}

TEST(Rollout, LeavesTheMapIntoTheUnknown) {
  const CostGrid grid(20, 20, kCell_m, -0.5, -0.5);  // the border is 0.5 m ahead
  RolloutSetup setup;
  const RolloutOutcome outcome = rollOut(0.5, 0.0, setup, grid, circle());
  EXPECT_EQ(outcome.end, End::Unknown);
  EXPECT_NEAR(outcome.endPoint.x, 0.5, 0.051);
  setup.allowUnknown = true;
  EXPECT_EQ(rollOut(0.5, 0.0, setup, grid, circle()).end, End::Horizon);
}

RC_GTEST_PROP(RolloutLaw, ItsPosesAreThoseOfTheArc, ()) {
  const CostGrid grid(400, 400, kCell_m, -10.0, -10.0);
  const RolloutSetup setup = anySetup();
  const double v = any(0.0, 1.0), w = any(-2.0, 2.0);
  const int steps = rollOut(v, w, setup, grid, circle()).steps;
  const auto poses = rolloutPoses({v, 0.0, w}, setup, steps, grid);
  RC_ASSERT(poses.size() == static_cast<std::size_t>(steps) + 1);
  for (int i = 0; i <= steps; ++i) {
    const TPose2D expected = onArc(setup.start, v, w, i * setup.horizon_s / steps);
    const TPose2D pose = poses[static_cast<std::size_t>(i)];
    RC_ASSERT(std::hypot(pose.x - expected.x, pose.y - expected.y) <
              3e-4);  // single precision, up to 120 steps
    RC_ASSERT(std::abs(std::remainder(pose.phi - expected.phi, 2 * M_PI)) < 1e-4);
  }
}

}  // namespace
}  // namespace bslnav
