#include <gmock/gmock.h>

#include "NavigationCycleRig.h"

namespace bslnav {
namespace {

using mrpt::math::TPose2D;
using test::CycleRig;
using test::kPeriod_s;
using test::makeMap;
using test::makeScan;
using test::method;
using Health = CycleRecord::Health;

/** A box 2 m away between 0° and 45° to the left, the rest at 5 m: jumps on both sides of it. */
double boxAhead(int bearing_deg) { return bearing_deg >= 0 && bearing_deg <= 45 ? 2.0 : 5.0; }

CycleRecord recordOfBox(int methodNumber, double roll_rad) {
  CycleRig rig(method(methodNumber));
  rig.pose = {1.0, 2.0, M_PI / 2.0};
  rig.twist.vx = 0.5;
  SensorFrame frame = rig.frame();
  auto scan = makeScan(0.0, boxAhead);
  scan->sensorPose = mrpt::poses::CPose3D(0.0, 0.0, 0.2, 0.0, 0.0, roll_rad);
  frame.scans = {scan};
  return rig.cycle.step(frame);
}

TEST(NavigationCycle, Method1HasNoBlindSpotsAndNoDangerZones) {
  const CycleRecord record = recordOfBox(1, 0.0);
  EXPECT_TRUE(record.blindSpots.empty());
  EXPECT_TRUE(record.dangerZones.empty());
}

TEST(NavigationCycle, Method2FindsBlindSpotsInTheRobotFrameAndZonesInTheMap) {
  const CycleRecord record = recordOfBox(2, 0.0);
  ASSERT_EQ(record.blindSpots.size(), 2u);
  EXPECT_NEAR(record.blindSpots[0].position.x, 2.0, 1e-5);  // at 0°
  EXPECT_NEAR(record.blindSpots[0].position.y, 0.0, 1e-5);
  EXPECT_NEAR(record.blindSpots[1].position.x, std::sqrt(2.0), 1e-5);  // at 45°
  EXPECT_NEAR(record.blindSpots[1].position.y, std::sqrt(2.0), 1e-5);
  // In the robot frame the second centre is (√2, √2 + 0.5 tan 45°) = (1.414, 1.914); the robot
  // looks along y from (1, 2): (1 − 1.914, 2 + 1.414). Radius v²/2a + L + X = 0.25 + 0.8 + 0.2.
  ASSERT_EQ(record.dangerZones.size(), 2u);
  EXPECT_NEAR(record.dangerZones[0].centre.x, 1.0, 1e-5);
  EXPECT_NEAR(record.dangerZones[0].centre.y, 4.0, 1e-5);
  EXPECT_NEAR(record.dangerZones[1].centre.x, -0.9142, 1e-4);
  EXPECT_NEAR(record.dangerZones[1].centre.y, 3.4142, 1e-4);
  EXPECT_NEAR(record.dangerZones[1].radius_m, 1.25, 1e-9);
}

TEST(NavigationCycle, ScanOfAnUpsideDownLaserIsMirrored) {
  const CycleRecord record = recordOfBox(2, M_PI);
  ASSERT_EQ(record.blindSpots.size(), 2u);  // counterclockwise: −45° first
  EXPECT_NEAR(record.blindSpots[0].bearing_rad, -M_PI / 4.0, 1e-5);
  EXPECT_NEAR(record.blindSpots[1].bearing_rad, 0.0, 1e-5);
}

TEST(NavigationCycle, DangerZonesRaiseLocalCostsButNotThoseOfTheGlobalPlanner) {
  CycleRig rig(method(2));
  rig.range_m = boxAhead;
  rig.step();  // zone around (2, 0) with a radius of 1 m; (2, −0.8) is free otherwise
  EXPECT_GT(rig.cycle.surroundings().localCosts().costAt(2.0, -0.8), 0);
  EXPECT_EQ(rig.cycle.surroundings().planningCosts().costAt(2.0, -0.8), 0);
}

TEST(NavigationCycle, BrakesWithoutGoals) {
  CycleRig rig;
  rig.twist = {0.4, 0.0, 0.5};
  const CycleRecord& record = rig.step();
  EXPECT_EQ(record.motion.mode, MotionMode::Idle);
  EXPECT_NEAR(record.motion.command.vx, 0.35, 1e-9);    // 0.5 m/s² · 0.1 s less
  EXPECT_NEAR(record.motion.command.omega, 0.3, 1e-9);  // 2 rad/s² · 0.1 s less
  EXPECT_EQ(reasonOf(record), "");
}

TEST(NavigationCycle, ForgetsThePathWhenTheGoalsAreTakenAway) {
  CycleRig rig;
  rig.cycle.setGoals({{3.0, 0.0, 0.0}});
  EXPECT_FALSE(rig.step().path.empty());
  rig.cycle.setGoals({});
  EXPECT_TRUE(rig.step().path.empty());
}

TEST(NavigationCycle, ArrivesAtTheGoalAndTakesUpItsHeading) {
  CycleRig rig(method(1), makeMap(-2.0, -2.0, 5.0, 3.0));
  rig.cycle.setGoals({{3.0, 1.0, M_PI / 2.0}});
  ASSERT_TRUE(rig.driveUntil(MotionMode::Arrived, 30.0));
  EXPECT_LT(std::hypot(rig.pose.x - 3.0, rig.pose.y - 1.0), 0.1);
  EXPECT_NEAR(rig.pose.phi, M_PI / 2.0, 0.1);
  EXPECT_TRUE(isStanding(rig.twist));
}

TEST(NavigationCycle, PassesWaypointsInOrderAndStopsAtTheLastOne) {
  CycleRig rig(method(1), makeMap(-2.0, -2.0, 6.0, 6.0));
  const std::vector<TPose2D> goals{{3.0, 0.0, 0.0}, {3.0, 3.0, 0.0}, {0.0, 3.0, M_PI}};
  rig.cycle.setGoals(goals);
  std::vector<int> passed;
  double slowestBetween_mps = 1.0;
  bool arrived = false;
  while (!arrived && rig.time_s < 60.0) {
    arrived = rig.step().motion.mode == MotionMode::Arrived;
    for (int i = 0; i < 3; ++i)
      if (std::hypot(rig.pose.x - goals[static_cast<std::size_t>(i)].x,
                     rig.pose.y - goals[static_cast<std::size_t>(i)].y) < 0.4 &&
          (passed.empty() || passed.back() != i))
        passed.push_back(i);
    if (!passed.empty() && passed.size() < 3)
      slowestBetween_mps = std::min(slowestBetween_mps, rig.twist.vx);
  }
  EXPECT_TRUE(arrived);
  EXPECT_THAT(passed, testing::ElementsAre(0, 1, 2));
  EXPECT_GT(slowestBetween_mps, 0.05);  // it drives through, without a stop
  EXPECT_LT(std::hypot(rig.pose.x, rig.pose.y - 3.0), 0.1);
}

TEST(NavigationCycle, PassesAWaypointInAnObstacleWhereThePathEnds) {
  const auto map = makeMap(-2.0, -2.0, 6.0, 2.0);
  test::occupy(*map, 2.45, -0.15, 2.75,
               0.15);  // free again 0.44 m from its middle, with the robot's radius
  CycleRig rig(method(1), map);
  rig.cycle.setGoals({{2.6, 0.0, 0.0}, {5.0, 0.0, 0.0}});
  EXPECT_TRUE(rig.driveUntil(MotionMode::Arrived, 40.0));
}

TEST(NavigationCycle, ApproachesAGoalBeyondTheLocalMapWithoutAMap) {
  NavigationParameters parameters = method(1);
  parameters.costmap.width_m = parameters.costmap.height_m = 6.0;
  parameters.cycle.replanPeriod_s =
      60.0;  // an arrival at the end of the first path would be too early
  CycleRig rig(parameters);
  rig.cycle.setGoals({{9.0, 2.0, 0.0}});
  EXPECT_LT(rig.step().path.back().x, 3.0);  // the local map ends there
  ASSERT_TRUE(rig.driveUntil(MotionMode::Arrived, 40.0));
  EXPECT_LT(std::hypot(rig.pose.x - 9.0, rig.pose.y - 2.0), 0.1);
}

TEST(NavigationCycle, ReportsNoPathWhenEnclosedAndStaysInside) {
  const auto map = makeMap(-3.0, -3.0, 3.0, 3.0);
  test::occupy(*map, 1.0, -3.0, 1.1, 3.0);
  CycleRig rig(method(1), map);
  rig.cycle.setGoals({{2.0, 0.0, 0.0}});
  const CycleRecord& record = rig.step();
  EXPECT_EQ(record.pathStatus, PathResult::Status::NoPath);
  EXPECT_TRUE(record.path.empty());
  EXPECT_TRUE(record.motion.blocked);
  EXPECT_EQ(reasonOf(record), "no path from start to goal");
  ASSERT_TRUE(rig.driveUntil(MotionMode::Failed, 120.0));
  EXPECT_LT(rig.pose.x, 0.75);
}

TEST(NavigationCycle, GivesTheSameRecordsForTheSameFrames) {
  CycleRig driven(method(2), makeMap(-2.0, -2.0, 8.0, 2.0));
  driven.range_m = boxAhead;
  NavigationCycle replayed(method(2), makeMap(-2.0, -2.0, 8.0, 2.0));
  for (NavigationCycle* cycle : {&driven.cycle, &replayed}) cycle->setGoals({{6.0, 0.5, 1.0}});
  for (int i = 0; i < 60; ++i) {
    const SensorFrame frame = driven.frame();
    const CycleRecord& a = driven.step(frame);
    const CycleRecord& b = replayed.step(frame);
    ASSERT_EQ(a.motion.command, b.motion.command);
    ASSERT_EQ(a.motion.mode, b.motion.mode);
    ASSERT_EQ(a.path, b.path);
    ASSERT_EQ(a.replanned, b.replanned);
    ASSERT_EQ(a.dwa.best, b.dwa.best);
    for (std::size_t k = 0; k < a.dwa.candidates.size(); ++k)
      ASSERT_EQ(a.dwa.candidates[k].total, b.dwa.candidates[k].total);
    ASSERT_EQ(a.dangerZones.size(), b.dangerZones.size());
    for (std::size_t k = 0; k < a.dangerZones.size(); ++k)
      ASSERT_EQ(a.dangerZones[k].centre, b.dangerZones[k].centre);
    ASSERT_EQ(driven.cycle.surroundings().localCosts().data(),
              replayed.surroundings().localCosts().data());
  }
  EXPECT_GT(driven.pose.x, 0.5);  // it did drive
}

/** Somebody stands 2.1 m beside the path, too far away for the guard to slow the robot down. */
TEST(NavigationCycle, ComesSlowlyToWhereSomebodyMayCross) {
  const auto speedThere = [](double share) {
    NavigationParameters parameters;
    parameters.guard.enabled = true;
    parameters.movers.approachShare = share;
    test::CycleRig rig(parameters);
    rig.range_m = [&rig](int deg) {
      const auto person = rig.pose.inverseComposePoint(mrpt::math::TPoint2D{2.5, -2.1});
      const double bearing = deg * M_PI / 180.0, c = std::cos(bearing), s = std::sin(bearing);
      const double along = person.x * c + person.y * s, across = person.y * c - person.x * s;
      const bool isHit = along > 0.0 && std::abs(across) < 0.22;  // not at the very edge
      return isHit ? along - std::sqrt(0.25 * 0.25 - across * across) : 0.0;
    };
    rig.cycle.setGoals({{5.0, 0.0, 0.0}});
    while (rig.pose.x < 1.7 && rig.time_s < 20.0) rig.step();
    return rig.twist.vx;
  };
  EXPECT_LT(speedThere(0.5), 0.4);
  EXPECT_GT(speedThere(1.0), 0.5);
}

}  // namespace
}  // namespace bslnav
