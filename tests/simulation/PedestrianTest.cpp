#include <bslnav/simulation/Pedestrian.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace bslnav
