#include <bslnav/navigation/Clearance.h>
#include <bslnav/navigation/InPlaceRotation.h>
#include <bslnav/navigation/MotionPlanner.h>
#include <bslnav/planning/DwaPlanner.h>
#include <gtest/gtest.h>
#include <mrpt/math/wrap2pi.h>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;

constexpr double kPeriod_s = 0.1, kCell_m = 0.05;
constexpr RobotLimits kLimits{};

/** An ideal robot in a map of 12 m × 12 m; every command is checked against the limits. */
class MotionPlannerTest : public testing::Test {
 protected:
  explicit MotionPlannerTest(const Footprint& footprint = {})
      : inflation({0.55, 10.0}, footprint.inscribedRadius_m(), kCell_m),
        cover(footprint, kCell_m, inflation),
        planner({}, {}, std::make_unique<DwaPlanner>(DwaParameters{}, kLimits, cover, kPeriod_s),
                kLimits, cover, kPeriod_s) {}

  void drawPath(double toX, double toY) {
    path.clear();
    const TPoint2D way{toX - pose.x, toY - pose.y};
    const int n = static_cast<int>(way.norm() / kCell_m);
    for (int i = 0; i <= n; ++i) path.push_back(TPoint2D{pose.x, pose.y} + way * (1.0 * i / n));
    goal = {toX, toY, goal.phi};
  }
  void block(double x0, double y0, double x1, double y1) {
    for (int y = base.cellY(y0); y <= base.cellY(y1); ++y)
      for (int x = base.cellX(x0); x <= base.cellX(x1); ++x) base.at(x, y) = kLethalCost;
    inflation.apply(base, base.bounds(), costs);
  }
  Motion step() {
    const Motion motion = planner.step(
        {time_s, pose, twist, twist, path, goal, 0.0, guard, movers, looksBehind}, costs);
    const TTwist2D allowed = limited(motion.command, twist, kLimits, kPeriod_s);
    EXPECT_NEAR(motion.command.vx, allowed.vx, 1e-9);
    EXPECT_NEAR(motion.command.omega, allowed.omega, 1e-9);
    twist = motion.command;
    const double middle = pose.phi + 0.5 * twist.omega * kPeriod_s;
    pose.x += twist.vx * kPeriod_s * std::cos(middle);
    pose.y += twist.vx * kPeriod_s * std::sin(middle);
    pose.phi += twist.omega * kPeriod_s;
    time_s += kPeriod_s;
    return motion;
  }
  /** Drives until this mode. */
  bool driveUntil(MotionMode mode, double seconds) {
    for (const double end_s = time_s + seconds; time_s < end_s;)
      if (step().mode == mode) return true;
    return false;
  }

  CostGrid base{240, 240, kCell_m, -6.0, -6.0}, costs = base;
  InflationLayer inflation;
  FootprintCover cover;
  MotionPlanner planner;
  TPose2D pose, goal;
  TTwist2D twist;
  std::vector<TPoint2D> path;
  const Guard* guard = nullptr;
  const MoverForecast* movers = nullptr;
  bool looksBehind = true;
  double time_s = 0.0;
};

/** Somebody stands beside the robot: it turns to the path, which leads away, and keeps to it at the
 * creeping speed, or at what is admissible if that is more, however long that takes. */
TEST_F(MotionPlannerTest, CreepsAlongThePathAwayFromSomebodyWhoStands) {
  GuardParameters parameters;
  Guard beside(parameters, kLimits, 0.25, kPeriod_s);
  guard = &beside;
  drawPath(-3.0, 0.5);
  double fastest_mps = 0.0;
  for (int k = 0; k < 250; ++k) {
    beside.begin(pose, {{0.5f, 0.0f, FrontierPoint::Kind::Standing}}, 0.0, false);
    const Motion motion = step();
    ASSERT_NE(motion.mode, MotionMode::BackOff);
    if (!beside.isBesideStanding()) break;
    EXPECT_TRUE(beside.admits(motion.command));
    fastest_mps = std::max(fastest_mps, motion.command.vx);
  }
  EXPECT_FALSE(beside.isBesideStanding());
  EXPECT_GT(fastest_mps, parameters.creepSpeed_mps + 0.01);
  EXPECT_LT(pose.x, -0.2);
}

/** Somebody crosses right before the robot, which stands with its front in the way. */
class MakesWay : public MotionPlannerTest {
 protected:
  void meet() {
    guard = &binding;
    drawPath(4.0, 0.0);
    MoverForecast forecast({}, binding.robot(), binding.parameters());
    movers = &forecast;
    for (int k = 0; k < 40; ++k) {
      const TPoint2D person{0.45, -2.0 + 0.1 * k};
      const Frontier seen{
          {static_cast<float>(person.x), static_cast<float>(person.y), FrontierPoint::Kind::Seen}};
      binding.begin(pose, seen, 0.0, false);
      forecast.begin(pose, {{person, {0.0, 1.0}}});
      step();
      nearest_m = std::min(nearest_m, (person - TPoint2D{pose.x, pose.y}).norm());
      driven_m = std::min(driven_m, pose.x);
    }
  }
  Guard binding{GuardParameters{}, kLimits, 0.25, kPeriod_s};
  double nearest_m = 10.0, driven_m = 0.0;
};

TEST_F(MakesWay, ByDrivingBackAsFarAsNeeded) {
  meet();
  EXPECT_GT(nearest_m, 0.55);
  EXPECT_LT(driven_m, -0.1);
  EXPECT_GT(driven_m, -0.5);
}

TEST_F(MakesWay, NotWhereItDoesNotLook) {
  looksBehind = false;
  meet();
  EXPECT_EQ(driven_m, 0.0);
}

TEST_F(MakesWay, NotIntoAWall) {
  block(-0.5, -1.0, -0.4, 1.0);
  meet();
  EXPECT_GT(driven_m, -0.15);
}

TEST_F(MotionPlannerTest, DrivesToTheGoalAndTakesUpItsHeading) {
  goal.phi = -2.0;
  drawPath(2.0, 1.0);
  ASSERT_TRUE(driveUntil(MotionMode::Arrived, 20.0));
  EXPECT_LT(std::hypot(pose.x - 2.0, pose.y - 1.0), 0.1);
  EXPECT_LT(std::abs(mrpt::math::wrapToPi(pose.phi + 2.0)), 0.1);
  EXPECT_TRUE(isStanding(twist));
}

TEST_F(MotionPlannerTest, TurnsOnTheSpotToAPathBehind) {
  drawPath(-3.0, 0.5);
  for (int i = 0; i < 60; ++i) {
    if (step().mode != MotionMode::RotateToPath) break;
    ASSERT_EQ(pose.x, 0.0);
  }
  EXPECT_LT(std::abs(bearingTo(pose, {-3.0, 0.5})), 0.25);
  EXPECT_EQ(step().mode, MotionMode::Follow);
}

TEST_F(MotionPlannerTest, DoesNotTurnOnTheSpotWhileDriving) {
  twist.vx = 0.4;
  drawPath(-3.0, 0.5);
  EXPECT_EQ(step().mode, MotionMode::Follow);
}

TEST_F(MotionPlannerTest, BrakesAndIsBlockedWithoutAPath) {
  twist.vx = 0.5;
  goal = {3.0, 0.0, 0.0};
  const Motion motion = step();
  EXPECT_TRUE(motion.blocked);
  EXPECT_FALSE(motion.planned);
  EXPECT_DOUBLE_EQ(motion.command.vx, 0.45);
}

TEST_F(MotionPlannerTest, WantsANewPathWhenBlockedAndGivesUpInTheEnd) {
  goal = {3.0, 0.0, 0.0};
  bool wanted = false;
  for (int i = 0; i < 30; ++i) {
    step();
    wanted = wanted || planner.wantsReplan();
  }
  EXPECT_TRUE(wanted);
  EXPECT_TRUE(driveUntil(MotionMode::Failed, 60.0));
  EXPECT_EQ(step().mode, MotionMode::Failed);
  planner.reset();
  drawPath(3.0, 0.0);
  EXPECT_NE(step().mode, MotionMode::Failed);
}

TEST_F(MotionPlannerTest, BacksOffFromAWallAhead) {
  block(0.3, -2.0, 0.4, 2.0);  // nearer than the horizon of any speed but zero
  drawPath(3.0, 0.0);
  ASSERT_TRUE(driveUntil(MotionMode::BackOff, 30.0));
  const double before = pose.x;
  while (step().mode == MotionMode::BackOff) {
  }
  EXPECT_LT(pose.x, before - 0.2);
}

TEST_F(MotionPlannerTest, BacksOffForwardsFromAnObstacleBehind) {
  block(-0.25, -0.1, -0.2, 0.1);  // the robot's radius is 0.25 m: it stands in the inflated area
  path.clear();
  goal = {3.0, 0.0, 0.0};
  ASSERT_TRUE(driveUntil(MotionMode::BackOff, 10.0));
  for (int i = 0; i < 20 && step().mode == MotionMode::BackOff; ++i) {
  }
  EXPECT_GT(pose.x, 0.1);
}

TEST_F(MotionPlannerTest, AcceptsTheHeadingItHasWithoutRoomToTurn) {
  goal = {0.0, 0.0, 2.0};
  path = {{0.0, 0.0}};
  block(0.1, 0.0, 0.15, 0.05);  // within the robot's circle: blocked whichever way it turns
  EXPECT_TRUE(driveUntil(MotionMode::Arrived, 1.0));
}

/** The same with a robot that is longer behind than a circle could tell. */
class LongRobotTest : public MotionPlannerTest {
 protected:
  LongRobotTest()
      : MotionPlannerTest({0.0, {{0.2, 0.2}, {-0.6, 0.2}, {-0.6, -0.2}, {0.2, -0.2}}}) {}
};

TEST_F(LongRobotTest, DoesNotBackOffIntoAPoleBehindItsTail) {
  block(-0.72, 0.0, -0.72, 0.0);
  goal = {3.0, 0.0, 0.0};  // no path: recovery begins
  const double nearest = clearance(costs, {0.0, 0.0}, 1.0);
  for (int i = 0; i < 100; ++i) {
    step();
    ASSERT_GT(clearance(costs, {pose.x, pose.y}, 1.0), nearest - 0.05);
  }
}

TEST_F(MotionPlannerTest, ComesBackWhenItStoppedBeyondTheGoal) {
  drawPath(2.0, 0.0);
  pose.x = 1.95;
  twist.vx = 0.5;  // stops 0.25 m on, beyond the tolerance of 0.1 m
  EXPECT_EQ(step().mode, MotionMode::StopAtGoal);
  ASSERT_TRUE(driveUntil(MotionMode::Arrived, 40.0));
  EXPECT_LE(std::hypot(pose.x - goal.x, pose.y - goal.y), 0.1 + 1e-9);
}

TEST(Clearance, IsTheDistanceToTheNearestLethalCellUpToALimit) {
  CostGrid grid(40, 40, kCell_m, 0.0, 0.0);
  grid.at(30, 20) = grid.at(20, 35) = kLethalCost;  // centres (1.525, 1.025), (1.025, 1.775)
  EXPECT_NEAR(clearance(grid, {1.025, 1.025}, 1.0), 0.5, 1e-9);
  EXPECT_EQ(clearance(grid, {1.025, 1.025}, 0.3), 0.3);
  EXPECT_EQ(clearance(grid, {-9.0, 0.0}, 0.3), 0.3);
}

}  // namespace
}  // namespace bslnav
