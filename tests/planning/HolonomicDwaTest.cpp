#include <bslnav/planning/DwaPlanner.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "DwaGenerators.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;
using test::any;

constexpr double kPeriod_s = 0.1;

RobotLimits holonomicLimits() {
  RobotLimits limits;
  limits.maxLateralSpeed_mps = 0.4;
  return limits;
}

DwaParameters parameters(int lateralSamples) {
  DwaParameters p;
  p.speedSamples = 10;
  p.yawRateSamples = 15;
  p.lateralSamples = lateralSamples;
  return p;
}

DwaPlanner planner(int lateralSamples, const RobotLimits& limits = holonomicLimits()) {
  const FootprintCover circle({}, 0.05, test::noInflation());
  return DwaPlanner(parameters(lateralSamples), limits, circle, kPeriod_s);
}

RC_GTEST_PROP(HolonomicDwaLaw, EveryCandidateCanBeReachedWithinTheWindow, ()) {
  const RobotLimits limits = test::anyHolonomicLimits();
  const TTwist2D twist = test::anyTwist(limits);
  const auto path = test::straightPath(2.5);
  const CostGrid grid = test::freeSpace();
  auto dwa = planner(5, limits);
  for (const Candidate& c : dwa.plan({{}, twist, path, path.back(), 0.1}, grid).candidates) {
    const TTwist2D reached = limited(c.twist(), twist, limits, parameters(5).window_s);
    RC_ASSERT(std::abs(reached.vx - c.v_mps) < 1e-9);
    RC_ASSERT(std::abs(reached.vy - c.vy_mps) < 1e-9);
    RC_ASSERT(std::abs(reached.omega - c.w_radps) < 1e-9);
  }
}

RC_GTEST_PROP(HolonomicDwaLaw, WithoutALateralWindowItIsADifferentialDrive, ()) {
  const RobotLimits plain = test::anyLimits();
  RobotLimits holonomic = plain;
  holonomic.maxLateralSpeed_mps = 0.3;
  const CostGrid grid = test::inflated(test::scattered(25), InflationLayer({0.4, 5.0}, 0.12, 0.05));
  const auto path = test::straightPath(2.5);
  const DwaInput input{{any(-1.0, 1.0), any(-1.0, 1.0), any(-M_PI, M_PI)},
                       test::anyTwist(plain),
                       path,
                       path.back(),
                       0.1};
  auto reference = planner(1, plain);
  const DwaResult expected = reference.plan(input, grid);
  // Lateral samples do not count for a robot that cannot move sideways; one sample is straight.
  for (auto dwa : {planner(5, plain), planner(1, holonomic)}) {
    const DwaResult& result = dwa.plan(input, grid);
    RC_ASSERT(result.best == expected.best);
    RC_ASSERT(result.command == expected.command);
    for (std::size_t i = 0; i < expected.candidates.size(); ++i)
      RC_ASSERT(result.candidates[i].total == expected.candidates[i].total);
  }
}

TEST(HolonomicDwa, DrivesSidewaysToAPathBesideIt) {
  const CostGrid grid = test::freeSpace();
  std::vector<TPoint2D> path;
  for (int i = 0; i <= 60; ++i) path.emplace_back(0.05 * i, 0.4);
  auto dwa = planner(7);
  const DwaResult& result = dwa.plan({{}, {0.4, 0.0, 0.0}, path, {3.0, 0.4}}, grid);
  ASSERT_EQ(result.status, DwaResult::Status::Ok);
  const Candidate& best = result.candidates[static_cast<std::size_t>(result.best)];
  EXPECT_GT(best.vy_mps, 0.0);
  EXPECT_GT(result.command.vy, 0.0);
}

TEST(HolonomicDwa, TheVelocityTermTakesTheSpeedOfTheVector) {
  const CostGrid grid = test::freeSpace();
  const auto path = test::straightPath(3.0);
  auto dwa = planner(7);
  for (const Candidate& c : dwa.plan({{}, {0.3, 0.1, 0.0}, path, {3.0, 0.0}}, grid).candidates)
    ASSERT_DOUBLE_EQ(c.terms.velocity, 1.0 / std::max(std::hypot(c.v_mps, c.vy_mps), 0.05));
}

/** Drives a robot that heads along x, in an ideal world, to a goal 3 m away in any direction ahead,
 * and brakes within the tolerance as MotionPlanner does; time until standing. */
struct Approach {
  double time_s = 0.0;
  TPose2D pose;

  explicit Approach(double bearing_rad) {
    auto dwa = planner(7);
    std::vector<TPoint2D> path;
    for (int i = 0; i <= 60; ++i)
      path.emplace_back(0.05 * i * std::cos(bearing_rad), 0.05 * i * std::sin(bearing_rad));
    const CostGrid grid = test::freeSpace();
    TTwist2D twist;
    bool stops = false;
    do {
      const TPoint2D left = path.back() - TPoint2D{pose.x, pose.y};
      stops = stops || left.norm() < 0.1;
      const TTwist2D command = stops
                                   ? brake(twist, holonomicLimits(), kPeriod_s)
                                   : dwa.plan({pose, twist, path, path.back(), 0.1}, grid).command;
      const TTwist2D allowed = limited(command, twist, holonomicLimits(), kPeriod_s);
      EXPECT_NEAR(std::hypot(command.vx - allowed.vx, command.vy - allowed.vy), 0.0, 1e-9);
      pose = test::onArc(pose, twist = command, kPeriod_s);
      time_s += kPeriod_s;
    } while (time_s < 60.0 && std::hypot(twist.vx, twist.vy) > 0.02);
  }
};

TEST(HolonomicDwa, NeitherCreepsToTheGoalNorOvershootsIt) {
  // 0.556 m/s, 0.5 m/s²: 1.11 s and 0.309 m to speed up and to brake, 4.29 s between.
  constexpr double kOptimum_s = 6.51;
  for (const double bearing : {0.0, 0.3, 0.5, -0.8}) {
    const Approach approach(bearing);
    EXPECT_LT(approach.time_s, 1.15 * kOptimum_s) << bearing;
    EXPECT_NEAR(std::hypot(approach.pose.x, approach.pose.y), 3.0, 0.1) << bearing;
  }
}

}  // namespace
}  // namespace bslnav
