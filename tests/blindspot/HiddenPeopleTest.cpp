#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "HiddenFixture.h"

namespace bslnav::test {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr double kWalk_mps = 1.0;

TEST(HiddenPeople, LooksBehindAsLongAsItsMemory) {
  HiddenPeople hidden = people();
  EXPECT_FALSE(hidden.looksBehind());
  const PlanarScan room = around([](double) { return 3.0; });
  const PlanarScan ahead = scanOf(std::vector<float>(361, 2.5f), M_PI);
  hidden.update({&room}, 0.0, {}, kWalk_mps);
  EXPECT_TRUE(hidden.looksBehind());
  hidden.update({&ahead}, 0.4, {}, kWalk_mps);
  EXPECT_TRUE(hidden.looksBehind());
  hidden.update({&ahead}, 0.6, {}, kWalk_mps);
  EXPECT_FALSE(hidden.looksBehind());
}

TEST(HiddenPeople, NobodyIsInARoundRoom) {
  const PlanarScan room = around([](double) { return 3.0; });
  HiddenPeople hidden = people();
  hidden.update({&room}, 0.0, {}, kWalk_mps);
  EXPECT_TRUE(hidden.frontier().empty());
}

/** A camera sees nothing nearer than 0.4 m. Between that and the robot, whose radius is 0.25 m,
 * nobody has room. */
TEST(HiddenPeople, NobodyIsBetweenTheRobotAndWhatItsCameraSees) {
  constexpr double kNearest_m = 0.4;
  std::vector<PlanarScan> sides;  // four that look along the sides of a square around the robot
  for (const double side : {0.0, 0.5 * M_PI, M_PI, -0.5 * M_PI}) {
    const std::vector<float> ranges(361, 2.5f);
    sides.push_back(
        scanOf(ranges, M_PI, {kNearest_m * std::cos(side), kNearest_m * std::sin(side), side}));
  }
  std::vector<const PlanarScan*> views;
  for (const PlanarScan& scan : sides) views.push_back(&scan);
  HiddenPeople hidden = people();
  hidden.update(views, 0.0, {}, kWalk_mps);
  EXPECT_GT(nearest(hidden.frontier()), 2.0);
}

/** Cameras off the robot's centre leave a strip between what they see and what is outside every
 * view: nobody has room in it. */
TEST(HiddenPeople, NobodyIsBesideTheViewOfCamerasOffTheCentre) {
  const std::vector<float> ranges(181, 2.5f);
  constexpr double kView_rad = 87.0 / 180.0 * M_PI, kAside_rad = 85.0 / 180.0 * M_PI;
  const PlanarScan front = scanOf(ranges, kView_rad, {0.1, 0.0, 0.0});
  const PlanarScan left = scanOf(ranges, kView_rad, {0.0, 0.1, kAside_rad});
  const PlanarScan right = scanOf(ranges, kView_rad, {0.0, -0.1, -kAside_rad});
  HiddenPeople hidden = people();
  for (int k = 0; k < 20; ++k) hidden.update({&front, &left, &right}, 0.1 * k, {}, kWalk_mps);
  EXPECT_GT(nearest(hidden.frontier()), 1.5);
}

/** The shadow of the wall begins at its end, (0.5, −1). Between the line of sight and the back of
 * the wall are 63.4 degrees, so the disc of a person that touches both has its centre 0.25 m /
 * sin(31.7°) = 0.475 m along the bisector, at (0.904, −1.25): the nearest body is at 1.29 m. */
TEST(HiddenPeople, StepOutBehindACorner) {
  const PlanarScan scan = around(corner);
  HiddenPeople hidden = people();
  hidden.update({&scan}, 0.0, {}, kWalk_mps);
  EXPECT_LE(nearest(hidden.frontier()), 1.29 + 0.035);
  EXPECT_GE(nearest(hidden.frontier()), 1.29 - 0.12);  // persons are rounded down to whole cells
  for (const auto& p : hidden.frontier()) EXPECT_LT(p.y_m, -0.95);
}

/** A second sensor that looks over the wall takes its shadow away. */
TEST(HiddenPeople, VisibleToOneSensorIsVisible) {
  const PlanarScan low = around(corner), high = around([](double) { return 3.0; });
  HiddenPeople alone = people(), both = people();
  alone.update({&low}, 0.0, {}, kWalk_mps);
  both.update({&low, &high}, 0.0, {}, kWalk_mps);
  EXPECT_FALSE(alone.frontier().empty());
  EXPECT_TRUE(both.frontier().empty());
}

/** A pole of 5 cm radius at 1 m: its shadow is wide enough for a disc of 25 cm only 5 m away. But
 * somebody may come through the wall behind it, of which 30 cm are not seen. */
TEST(HiddenPeople, NobodyFitsBehindAThinPole) {
  const PlanarScan scan = around([](double angle) { return std::abs(angle) < 0.05 ? 0.95 : 3.0; });
  HiddenPeople hidden = people();
  hidden.update({&scan}, 0.0, {}, kWalk_mps);
  EXPECT_GT(nearest(hidden.frontier()), 2.8);
}

/** Behind a body 0.5 m wide at 1 m somebody fits into its shadow, but not into the body itself. */
TEST(HiddenPeople, NobodyIsInTheBodyOfSomebodySeen) {
  const auto disc = [](double angle) {
    const double across = 1.25 * std::sin(angle);
    return std::abs(angle) < 0.2 ? 1.25 * std::cos(angle) - std::sqrt(0.0625 - across * across)
                                 : 3.0;
  };
  const PlanarScan scan = around(disc);
  HiddenPeople anything = people(), somebody = people();
  anything.update({&scan}, 0.0, {}, kWalk_mps);
  somebody.look({&scan}, {}, 0.0, {}, kWalk_mps);
  somebody.findFrontier({{1.0, 0.0}});
  EXPECT_LT(nearest(anything.frontier()), 1.25);
  EXPECT_GT(nearest(somebody.frontier()), 1.35);
  EXPECT_LT(nearest(somebody.frontier()), 1.75);  // who touches the body from behind
}

/** In what the map calls occupied stands nobody. */
TEST(HiddenPeople, NobodyIsInsideWalls) {
  auto map = std::make_shared<mrpt::maps::COccupancyGridMap2D>(-6.0f, 6.0f, -6.0f, 6.0f, 0.05f);
  map->fill(0.95f);
  for (float y = -6.0f; y < -1.0f; y += 0.05f)
    for (float x = -6.0f; x < 6.0f; x += 0.05f) map->setPos(x, y, 0.05f);
  const PlanarScan scan = around(corner);
  HiddenPeople hidden = people({}, map);
  hidden.update({&scan}, 0.0, {}, kWalk_mps);
  EXPECT_TRUE(hidden.frontier().empty());
}

/** A laser with a narrow view: behind it, nobody is assumed, or what was there stays there. Behind
 * the wall that it sees, 3 m away, somebody may be either way. */
TEST(HiddenPeople, OutsideTheViewIsAChoice) {
  const PlanarScan ahead = scanOf(std::vector<float>(181, 3.0f), M_PI / 2.0);
  HiddenPeopleParameters remembered;
  remembered.outsideView = HiddenPeopleParameters::OutsideView::Remembered;
  HiddenPeople hidden = people(), wary = people(remembered);
  hidden.update({&ahead}, 0.0, {}, kWalk_mps);
  wary.update({&ahead}, 0.0, {}, kWalk_mps);
  EXPECT_GT(nearest(hidden.frontier()), 2.8);
  EXPECT_LT(nearest(wary.frontier()), 0.5);
}

/** A grid that is smaller than the robot: nobody is where the robot is, and nothing else is known.
 */
TEST(HiddenPeople, ARobotMayBeLargerThanTheGrid) {
  HiddenPeopleParameters parameters;
  parameters.reach_m = 1.0;
  HiddenPeople hidden(parameters, 1.6, nullptr, {});
  const PlanarScan scan = around(corner);
  hidden.update({&scan}, 0.0, {}, kWalk_mps);
  EXPECT_TRUE(hidden.frontier().empty());
}

/** A camera looks over low things: where a laser looks, or meets something just before, it is the
 * laser that tells whether they are gone. */
TEST(HiddenPeople, ForgetObstaclesWhereASensorSeesThatTheyAreGone) {
  const auto free = [](double) { return 3.5; };
  const PlanarScan camera = around(free);
  const PlanarScan open = scanOf(std::vector<float>(181, 3.5f), M_PI / 2.0),
                   blocked = scanOf(std::vector<float>(181, 1.5f), M_PI / 2.0);
  const auto isKept = [&camera](const PlanarScan& laser, double x_m) {
    HiddenPeople hidden = people();
    hidden.look({&laser}, {}, 0.0, {}, kWalk_mps);
    hidden.standing().add({x_m, 0.0}, {x_m, 0.0});
    hidden.look({&laser}, {&camera}, 0.1, {}, kWalk_mps);
    return hidden.standing().isNear({x_m, 0.0}, 0.0);
  };
  EXPECT_FALSE(isKept(open, 2.0));
  EXPECT_FALSE(isKept(open, -2.0));
  EXPECT_TRUE(isKept(blocked, 2.0));
  EXPECT_FALSE(isKept(blocked, 2.8));
}

/** The same view from anywhere gives the same frontier, but for the cells. */
TEST(HiddenPeople, MoveWithTheRobot) {
  const PlanarScan scan = around(corner);
  HiddenPeople here = people(), there = people();
  const TPose2D pose{7.35, -3.15, M_PI / 2.0};
  here.update({&scan}, 0.0, {}, kWalk_mps);
  there.update({&scan}, 0.0, pose, kWalk_mps);
  EXPECT_NEAR(nearest(here.frontier()), nearest(there.frontier(), {pose.x, pose.y}), 0.08);
  EXPECT_NEAR(double(here.frontier().size()), double(there.frontier().size()), 8.0);
}

}  // namespace
}  // namespace bslnav::test
