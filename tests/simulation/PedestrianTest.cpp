#include <bslnav/simulation/Pedestrian.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "TestWorld.h"

namespace bslnav {
namespace {

/** 3 m ahead, then 2 m to the left, at 1 m/s, triggered by crossing x = 2 between y = -1 and 1. */
PedestrianParameters cornerWalk() {
  auto parameters = test::walker({{0, 0}, {3, 0}, {3, 2}}, 1.0);
  parameters.triggerLine_m = {{2, -1}, {2, 1}};
  return parameters;
}

void expectAt(const mrpt::math::TPoint2D& p, double x, double y) {
  EXPECT_NEAR(p.x, x, 1e-12);
  EXPECT_NEAR(p.y, y, 1e-12);
}

TEST(Pedestrian, WaitsForTheTrigger) {
  Pedestrian person(cornerWalk());
  person.observeRobot({0, 0}, 0.0, {1.9, 0}, 9.0);
  EXPECT_FALSE(person.started(100.0));
  expectAt(person.position(100.0), 0.0, 0.0);
  EXPECT_EQ(person.speed_mps(100.0), 0.0);
}

TEST(Pedestrian, StartsAtTheExactTimeOfTheCrossing) {
  Pedestrian person(cornerWalk());
  person.observeRobot({1.8, 0.5}, 10.0, {2.2, 0.5}, 10.4);  // reaches x = 2 half way, at 10.2 s
  EXPECT_FALSE(person.started(10.199));
  EXPECT_TRUE(person.started(10.2 + 1e-9));
  expectAt(person.position(11.2), 1.0, 0.0);
}

TEST(Pedestrian, CrossingBackwardsTriggersToo) {
  Pedestrian person(cornerWalk());
  person.observeRobot({2.5, 0}, 0.0, {1.5, 0}, 1.0);
  EXPECT_TRUE(person.started(0.5 + 1e-9));
}

TEST(Pedestrian, PassingBesideTheTriggerLineDoesNotStart) {
  Pedestrian person(cornerWalk());
  person.observeRobot({1.5, 1.1}, 0.0, {2.5, 1.1}, 1.0);
  EXPECT_FALSE(person.started(100.0));
}

TEST(Pedestrian, LaterCrossingsDoNotStartAgain) {
  Pedestrian person(cornerWalk());
  person.observeRobot({1.5, 0}, 0.0, {2.5, 0}, 1.0);
  person.observeRobot({2.5, 0}, 1.0, {1.5, 0}, 2.0);
  expectAt(person.position(2.0), 1.5, 0.0);  // walking since 0.5 s
}

TEST(Pedestrian, WaitsForTheDelayAfterTheTrigger) {
  auto parameters = cornerWalk();
  parameters.startDelay_s = 2.0;
  Pedestrian person(parameters);
  person.observeRobot({1.5, 0}, 0.0, {2.5, 0}, 1.0);
  EXPECT_FALSE(person.started(2.4));
  expectAt(person.position(3.0), 0.5, 0.0);  // 0.5 s after 0.5 + 2 s
}

TEST(Pedestrian, WithoutTriggerLineStartsAtOnce) {
  const Pedestrian person(test::walker({{0, 0}, {3, 0}}, 1.5));
  EXPECT_TRUE(person.started(0.0));
  expectAt(person.position(1.0), 1.5, 0.0);
  EXPECT_EQ(person.speed_mps(1.0), 1.5);
}

TEST(Pedestrian, TurnsAtTheCornersOfThePath) {
  Pedestrian person(test::walker({{0, 0}, {3, 0}, {3, 2}}, 1.0));
  expectAt(person.position(3.0), 3.0, 0.0);
  expectAt(person.position(4.0), 3.0, 1.0);
}

TEST(Pedestrian, StopsAtTheEndOfTheWalk) {
  Pedestrian person(test::walker({{0, 0}, {3, 0}, {3, 2}}, 1.0));
  EXPECT_EQ(person.speed_mps(4.9), 1.0);
  EXPECT_EQ(person.speed_mps(5.1), 0.0);
  expectAt(person.position(50.0), 3.0, 2.0);
  EXPECT_TRUE(person.started(50.0));
}

TEST(Pedestrian, PausesOnceOnTheWay) {
  auto parameters = test::walker({{0, 0}, {3, 0}}, 1.0);
  parameters.pauseAfter_m = 1.0;
  parameters.pause_s = 2.0;
  const Pedestrian person(parameters);
  expectAt(person.position(0.5), 0.5, 0.0);
  expectAt(person.position(1.5), 1.0, 0.0);
  expectAt(person.position(2.9), 1.0, 0.0);
  expectAt(person.position(3.5), 1.5, 0.0);
  expectAt(person.position(9.0), 3.0, 0.0);
  EXPECT_EQ(person.speed_mps(0.5), 1.0);
  EXPECT_EQ(person.speed_mps(2.0), 0.0);
  EXPECT_EQ(person.speed_mps(4.0), 1.0);
  EXPECT_EQ(person.speed_mps(9.0), 0.0);
}

TEST(Pedestrian, WhoYieldsWaitsForTheRobotAndThenWalksOn) {
  auto parameters = test::walker({{0, 0}, {3, 0}}, 1.0);
  parameters.yieldsWithin_m = 0.6;
  Pedestrian person(parameters);
  for (int i = 0; i < 400; ++i) person.observeRobot({2, 0}, i * 0.01, {2, 0}, (i + 1) * 0.01);
  EXPECT_NEAR(person.position(4.0).x, 1.4, 0.011);  // 0.6 m before the robot that stands there
  for (int i = 400; i < 500; ++i) person.observeRobot({2, 5}, i * 0.01, {2, 5}, (i + 1) * 0.01);
  EXPECT_NEAR(person.position(5.0).x, 2.4, 0.011);
}

TEST(Pedestrian, WhoYieldsWalksAwayFromARobotThatIsNear) {
  auto parameters = test::walker({{0, 0}, {3, 0}}, 1.0);
  parameters.yieldsWithin_m = 0.6;
  Pedestrian person(parameters);
  for (int i = 0; i < 100; ++i) person.observeRobot({-0.3, 0}, i * 0.01, {-0.3, 0}, (i + 1) * 0.01);
  expectAt(person.position(1.0), 1.0, 0.0);
}

/** Walks 4 m along x and yields; the robot stands at x = 2, a little to the right of the way. */
class WalkRound : public testing::Test {
 protected:
  WalkRound() {
    parameters_.yieldsWithin_m = 0.6;
    parameters_.walksRoundAfter_s = 1.0;
  }

  /** Walks for 8 s; the place at each end of 10 ms. */
  std::vector<mrpt::math::TPoint2D> walk(const WorldParameters& world = {}) const {
    const auto solids = worldShapes(world);
    Pedestrian person(parameters_);
    std::vector<mrpt::math::TPoint2D> places;
    for (int i = 0; i < 800; ++i) {
      person.observeRobot(robot_, i * 0.01, robot_, (i + 1) * 0.01);
      person.walkRound(robot_, (i + 1) * 0.01, solids);
      places.push_back(person.position((i + 1) * 0.01));
    }
    return places;
  }

  void expectGoesRound(const std::vector<mrpt::math::TPoint2D>& places, double side) const {
    for (const auto& place : places) {
      EXPECT_GT((place - robot_).norm(), 0.59);
      if (std::abs(place.x - robot_.x) < 0.1) EXPECT_GT((place.y - robot_.y) * side, 0.59);
    }
    expectAt(places.back(), 4.0, 0.0);
  }

  PedestrianParameters parameters_ = test::walker({{0, 0}, {4, 0}}, 1.0);
  mrpt::math::TPoint2D robot_{2.0, -0.1};
};

TEST_F(WalkRound, TakesTheShorterSideAtTheSameSpeed) {
  const auto places = walk();
  expectGoesRound(places, 1.0);
  for (std::size_t i = 1; i < places.size(); ++i)
    EXPECT_LT((places[i] - places[i - 1]).norm(), 0.01 + 1e-9);
}

TEST_F(WalkRound, TakesTheOtherSideWhereThereIsAWall) {
  WorldParameters world;
  world.walls["left"] = test::wall({0, 0.6}, {4, 0.6});
  expectGoesRound(walk(world), -1.0);
}

TEST_F(WalkRound, WaitsWhereBothSidesAreBlocked) {
  WorldParameters world;
  world.walls["left"] = test::wall({0, 0.6}, {4, 0.6});
  world.walls["right"] = test::wall({0, -0.8}, {4, -0.8});
  EXPECT_NEAR(walk(world).back().x, 1.4, 0.02);
}

TEST_F(WalkRound, WaitsWhereTheWayEndsAtTheRobot) {
  robot_ = {3.8, 0.0};
  EXPECT_NEAR(walk().back().x, 3.2, 0.02);
}

TEST_F(WalkRound, StepsOutFirstWhenTheRobotCameNear) {
  Pedestrian person(parameters_);
  const mrpt::math::TPoint2D near(1.4, 0.1);
  for (int i = 0; i < 800; ++i) {
    const auto& robot = i < 100 ? robot_ : near;  // 0.4 m before the person at x = 1
    person.observeRobot(robot, i * 0.01, robot, (i + 1) * 0.01);
    person.walkRound(robot, (i + 1) * 0.01, {});
    if (i > 100) EXPECT_GT((person.position((i + 1) * 0.01) - near).norm(), 0.4);
  }
  expectAt(person.position(8.0), 4.0, 0.0);
}

TEST_F(WalkRound, LeavesNothingOutOfAWayThatTurnsBack) {
  parameters_.path_m = {{0, 0}, {3.5, 0}, {2.8, 0}};  // heads for the robot again at the end
  const auto places = walk();
  expectAt(places.back(), 2.8, 0.0);
  const auto reaches = [](const auto& place) { return place.x > 3.49; };
  EXPECT_TRUE(std::any_of(places.begin(), places.end(), reaches));
}

TEST_F(WalkRound, PausesWhereThePauseIsOnThePath) {
  parameters_.pauseAfter_m = 3.0;
  parameters_.pause_s = 100.0;
  expectAt(walk().back(), 3.0, 0.0);
}

TEST_F(WalkRound, WaitsWithoutTheParameter) {
  parameters_.walksRoundAfter_s = 0.0;
  EXPECT_NEAR(walk().back().x, 1.4, 0.02);
}

}  // namespace
}  // namespace bslnav
