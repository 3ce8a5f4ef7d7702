#include <bslnav/planning/Rollout.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "DwaGenerators.h"

namespace bslnav {
namespace {

using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;
using test::any;
using test::onArc;
using End = RolloutOutcome::End;

FootprintCover circle() { return FootprintCover({}, 0.05, test::noInflation()); }

TTwist2D anyVelocity() {
  return {any(-0.7, 0.7), any(-0.7, 0.7), *rc::gen::element(0.0, 1e-9, any(-2.0, 2.0))};
}

RC_GTEST_PROP(HolonomicRolloutLaw, ItsPosesAreThoseOfTheConstantTwist, ()) {
  const CostGrid grid(400, 400, 0.05, -10.0, -10.0);
  const RolloutSetup setup = test::anySetup();
  const TTwist2D twist = anyVelocity();
  const RolloutOutcome outcome = rollOut(twist, setup, grid, circle());
  RC_ASSERT(outcome.end == End::Horizon);
  const auto poses = rolloutPoses(twist, setup, outcome.steps, grid);
  RC_ASSERT(poses.size() == static_cast<std::size_t>(outcome.steps) + 1);
  for (int i = 0; i <= outcome.steps; ++i) {
    const TPose2D expected = onArc(setup.start, twist, i * setup.horizon_s / outcome.steps);
    const TPose2D& pose = poses[static_cast<std::size_t>(i)];
    RC_ASSERT(std::hypot(pose.x - expected.x, pose.y - expected.y) < 3e-4);  // single precision
    RC_ASSERT(std::abs(std::remainder(pose.phi - expected.phi, 2 * M_PI)) < 1e-4);
  }
  RC_ASSERT((outcome.endPoint - mrpt::math::TPoint2D(poses.back())).norm() < 1e-6);
}

RC_GTEST_PROP(HolonomicRolloutLaw, SteersAroundLikeARobotThatHeadsWhereItGoes, ()) {
  // Seen from its centre, a round robot's way does not tell where its front is.
  const CostGrid grid = test::inflated(test::scattered(25), InflationLayer({0.4, 5.0}, 0.12, 0.05));
  RolloutSetup setup = test::anySetup();
  const TTwist2D twist = anyVelocity();
  const RolloutOutcome sideways = rollOut(twist, setup, grid, circle());
  setup.start.phi += std::atan2(twist.vy, twist.vx);
  const RolloutOutcome ahead =
      rollOut(std::hypot(twist.vx, twist.vy), twist.omega, setup, grid, circle());
  RC_ASSERT(sideways.steps == ahead.steps);
  RC_ASSERT(sideways.end == ahead.end);
  RC_ASSERT(sideways.highestCost == ahead.highestCost);
}

TEST(HolonomicRollout, MeetsAWallAtItsSide) {
  const CostGrid grid = test::wallFrom(1.0);
  RolloutSetup setup;
  setup.start.phi = -M_PI / 2;  // the wall is on the left
  EXPECT_EQ(rollOut({0.3, 0.4, 0.0}, setup, grid, circle()).end, End::Obstacle);
  EXPECT_EQ(rollOut({0.3, -0.4, 0.0}, setup, grid, circle()).end, End::Horizon);
  EXPECT_EQ(rollOut({0.3, 0.0, 0.0}, setup, grid, circle()).end, End::Horizon);
}

TEST(HolonomicRollout, PassesAGoalAtItsSide) {
  const CostGrid grid = test::freeSpace();
  RolloutSetup setup;
  setup.goal = {0.0, 1.0};
  setup.goalTolerance_m = 0.1;
  const RolloutOutcome outcome = rollOut({0.0, 0.4, 0.0}, setup, grid, circle());
  EXPECT_EQ(outcome.end, End::Goal);
  EXPECT_NEAR(outcome.endPoint.y, 1.0, 1e-5);
}

}  // namespace
}  // namespace bslnav
