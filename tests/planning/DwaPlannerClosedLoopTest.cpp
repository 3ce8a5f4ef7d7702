#include <bslnav/planning/DwaPlanner.h>
#include <gtest/gtest.h>

#include "DwaGenerators.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;
using test::freeSpace;
using test::wallFrom;

constexpr double kPeriod_s = 0.1;
constexpr RobotLimits kLimits{};

DwaPlanner planner(const DwaParameters& parameters) {
  return DwaPlanner(parameters, kLimits, FootprintCover({}, 0.05, test::noInflation()), kPeriod_s);
}

TPose2D driven(const TPose2D& pose, const TTwist2D& twist) {
  const double middle = pose.phi + 0.5 * twist.omega * kPeriod_s, way = twist.vx * kPeriod_s;
  return {pose.x + way * std::cos(middle), pose.y + way * std::sin(middle),
          pose.phi + twist.omega * kPeriod_s};
}

TEST(DwaPlanner, StopsInFrontOfAWall) {
  const CostGrid grid = wallFrom(2.0);
  const auto path = test::straightPath(5.0);
  auto dwa = planner({});
  TPose2D pose;
  TTwist2D twist{0.5, 0.0, 0.0};
  for (int i = 0; i < 300; ++i) {
    const TTwist2D command = dwa.plan({pose, twist, path, {3.0, 0.0}}, grid).command;
    const TTwist2D allowed = limited(command, twist, kLimits, kPeriod_s);
    ASSERT_NEAR(command.vx, allowed.vx, 1e-12);
    ASSERT_NEAR(command.omega, allowed.omega, 1e-12);
    pose = driven(pose, twist = command);
    ASSERT_LT(grid.costAt(pose.x, pose.y), kInscribedCost);
  }
  EXPECT_LT(twist.vx, 0.02);
}

/** Drives from the origin to a goal 3 m away, in an ideal world; time until standing. */
struct Approach {
  double time_s = 0.0;
  TPose2D pose;

  Approach(double heading_rad, const CostWeights& weights) {
    DwaParameters parameters;
    parameters.weights = weights;
    auto dwa = planner(parameters);
    pose.phi = heading_rad;
    std::vector<TPoint2D> path;
    for (int i = 0; i <= 60; ++i)
      path.emplace_back(0.05 * i * std::cos(heading_rad), 0.05 * i * std::sin(heading_rad));
    const CostGrid grid = freeSpace();
    TTwist2D twist;
    do {
      twist = dwa.plan({pose, twist, path, path.back(), 0.1}, grid).command;
      pose = driven(pose, twist);
      time_s += kPeriod_s;
    } while (time_s < 60.0 && twist.vx > 0.02);
  }
};

TEST(DwaPlanner, NeitherCreepsToTheGoalNorOvershootsIt) {
  // 0.556 m/s, 0.5 m/s²: 1.11 s and 0.309 m to speed up and to brake, 4.29 s between.
  constexpr double kOptimum_s = 6.51;
  for (const double velocity : {0.0, 0.5})
    for (const double heading : {0.0, 0.3, 2.0, -2.5}) {
      const Approach approach(heading, {2.0, 1.0, 10.0, velocity});
      EXPECT_LT(approach.time_s, 1.15 * kOptimum_s) << heading << " " << velocity;
      EXPECT_NEAR(std::hypot(approach.pose.x, approach.pose.y), 3.0, 0.1)
          << heading << " " << velocity;
    }
}

}  // namespace
}  // namespace bslnav
