#include <bslnav/navigation/Maneuvers.h>
#include <bslnav/navigation/MotionPlanner.h>
#include <bslnav/planning/DwaPlanner.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TTwist2D;

constexpr double kPeriod_s = 0.1, kCell_m = 0.05;

/** An ideal robot that may move sideways, too; a wall across its way. */
class StoppingRoom : public testing::TestWithParam<double> {
 protected:
  StoppingRoom() {
    limits.maxLateralSpeed_mps = GetParam();
    const int x = base.cellX(1.0);
    for (int y = 0; y < base.height(); ++y) base.at(x, y) = kLethalCost;
    inflation.apply(base, base.bounds(), costs);
  }
  /** Free of the wall: the centre may come as near as the inscribed radius. */
  double room_m() const {
    return base.getXMin() + base.cellX(1.0) * kCell_m - 0.25 - 0.5 * kCell_m;
  }
  /** Whether it touches within so many cycles of a planner that is new, with the guard. */
  bool touchesWithin(int cycles) {
    MotionPlanner planner({}, {},
                          std::make_unique<DwaPlanner>(DwaParameters{}, limits, cover, kPeriod_s),
                          limits, cover, kPeriod_s);
    const mrpt::math::TPose2D goal{path.back().x, path.back().y, 0.0};
    bool touching = false;
    for (int i = 0; i < cycles; ++i) {
      guard.begin(pose, {}, 0.0, false);
      move(planner.step({time_s, pose, twist, twist, path, goal, 0.0, &guard}, costs).command);
      touching = touching || touches();
    }
    return touching;
  }
  template <typename Part>
  void standAmongPillars(const Part& part) {
    base.fill(kFreeCost);
    for (int i = 0; i < 45; ++i) {
      const int x = base.cellX(2.5 * part()), y = base.cellY(2.5 * part());
      for (const int dx : {0, 1})
        for (const int dy : {0, 1}) base.at(x + dx, y + dy) = kLethalCost;
    }
    inflation.apply(base, base.bounds(), costs);
    pose = {part(), part(), 3.0 * part()};
    twist = {0.5, 0.5 * GetParam() * part(), part()};
    path = {{pose.x, pose.y}, {2.0 * part(), 2.0 * part()}};
  }
  void move(const TTwist2D& command) {
    twist = command;
    const double middle = pose.phi + 0.5 * twist.omega * kPeriod_s;
    pose.x += (twist.vx * std::cos(middle) - twist.vy * std::sin(middle)) * kPeriod_s;
    pose.y += (twist.vx * std::sin(middle) + twist.vy * std::cos(middle)) * kPeriod_s;
    pose.phi += twist.omega * kPeriod_s;
    time_s += kPeriod_s;
  }
  bool touches() const { return costs.costAt(pose.x, pose.y) >= kInscribedCost; }

  RobotLimits limits;
  Footprint footprint;
  CostGrid base{140, 140, kCell_m, -3.5, -3.5}, costs = base;
  InflationLayer inflation{{0.55, 10.0}, footprint.inscribedRadius_m(), kCell_m};
  FootprintCover cover{footprint, kCell_m, inflation};
  mrpt::math::TPose2D pose;
  TTwist2D twist;
  std::vector<TPoint2D> path;
  Guard guard{{}, limits, 0.25, kPeriod_s};  // nobody is hidden
  double time_s = 0.0;
};

TEST_P(StoppingRoom, IsWhatTheSpeedNeedsAndTheBaseTrails) {
  const Maneuvers maneuvers(limits, cover, kPeriod_s);
  const double v = 0.5, needed = v * (kPeriod_s + limits.response_s) + 0.5 * v * v / 0.5;
  for (const double spare : {-0.1, 0.1}) {
    pose.x = room_m() - needed - spare;
    const MotionInput input{0.0, pose, {}, {}, path, {}, 0.0};
    EXPECT_EQ(maneuvers.canStopAfter({v, 0.0, 0.0}, input, costs), spare > 0.0);
    EXPECT_TRUE(maneuvers.canStopAfter({-v, 0.0, 0.0}, input, costs));
    EXPECT_TRUE(maneuvers.canStopAfter({}, input, costs));
  }
}

TEST_P(StoppingRoom, IsAskedForOnUnknownGroundToo) {
  for (int y = 0; y < costs.height(); ++y)
    for (int x = 0; x < costs.width(); ++x)
      if (costs.at(x, y) < kInscribedCost) costs.at(x, y) = kUnknownCost;
  const Maneuvers maneuvers(limits, cover, kPeriod_s);
  pose.x = room_m() - 0.3;
  const MotionInput input{0.0, pose, {}, {}, path, {}, 0.0};
  EXPECT_FALSE(maneuvers.canStopAfter({0.5, 0.0, 0.0}, input, costs));
  EXPECT_TRUE(maneuvers.canStopAfter({-0.5, 0.0, 0.0}, input, costs));
}

/** Every candidate is free from where the robot is, but the way from one velocity to the other need
 * not be: whoever could have stopped must not touch a pillar. */
TEST_P(StoppingRoom, IsKeptWhateverThePlannerWants) {
  const Maneuvers maneuvers(limits, cover, kPeriod_s);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  int tried = 0, touched = 0;
  for (int k = 0; k < 1000; ++k) {
    standAmongPillars([&] { return part(random); });
    const MotionInput input{0.0, pose, twist, twist, path, {}, 0.0};
    const TTwist2D slower = brake(twist, limits, kPeriod_s);
    if (touches() || !maneuvers.canStopAfter(slower, input, costs)) continue;
    ++tried;
    touched += touchesWithin(12);
  }
  EXPECT_GT(tried, 100);
  EXPECT_EQ(touched, 0);
}

INSTANTIATE_TEST_SUITE_P(Lateral, StoppingRoom, testing::Values(0.0, 0.4));

}  // namespace
}  // namespace bslnav
