#include <bslnav/blindspot/HiddenPeople.h>
#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "ScanFixture.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr double kWalk_mps = 1.0;

/** A scan of the full circle with a beam each half degree; `range` is that of a direction. */
PlanarScan around(const std::function<double(double)>& range_m) {
  std::vector<float> ranges;
  constexpr int kBeams = 720;
  for (int i = 0; i < kBeams; ++i)
    ranges.push_back(static_cast<float>(range_m(-M_PI + 2.0 * M_PI * i / kBeams)));
  return test::scanOf(ranges, 2.0 * M_PI * (kBeams - 1) / kBeams, {0.0, 0.0, -M_PI / kBeams});
}

/** The view from the middle of a round room of 3 m with a wall along y = −1 from x = 0.5 on. */
double corner(double angle) {
  if (angle >= 0.0 || angle <= -M_PI / 2.0) return 3.0;
  const double range = -1.0 / std::sin(angle);
  return range * std::cos(angle) >= 0.5 ? std::min(3.0, range) : 3.0;
}

HiddenPeople people(const HiddenPeopleParameters& parameters = {},
                    const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map = nullptr) {
  return HiddenPeople(parameters, 0.25, map, {});
}

double nearest(const Frontier& frontier, const TPoint2D& from = {}) {
  double least = 1e9;
  for (const auto& p : frontier)
    least = std::min(least, std::hypot(p.x_m - from.x, p.y_m - from.y));
  return least;
}

TEST(HiddenPeople, LooksBehindAsLongAsItsMemory) {
  HiddenPeople hidden = people();
  EXPECT_FALSE(hidden.looksBehind());
  const PlanarScan room = around([](double) { return 3.0; });
  const PlanarScan ahead = test::scanOf(std::vector<float>(361, 2.5f), M_PI);
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
    sides.push_back(test::scanOf(ranges, M_PI,
                                 {kNearest_m * std::cos(side), kNearest_m * std::sin(side), side}));
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
  const PlanarScan front = test::scanOf(ranges, kView_rad, {0.1, 0.0, 0.0});
  const PlanarScan left = test::scanOf(ranges, kView_rad, {0.0, 0.1, kAside_rad});
  const PlanarScan right = test::scanOf(ranges, kView_rad, {0.0, -0.1, -kAside_rad});
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

/** What was seen empty stays so until somebody can have walked there: the nearest hiding place is
 * outside the round room, and a pillar of half a metre hides nobody who was not there before. */
TEST(HiddenPeople, RememberWhatWasSeenEmpty) {
  const auto room = [](double) { return 3.0; };
  const auto pillar = [](double angle) { return std::abs(angle) < 0.5 ? 1.0 : 3.0; };
  const PlanarScan before = around(room), after = around(pillar);
  HiddenPeople known = people(), unknown = people();
  known.update({&before}, 0.0, {}, kWalk_mps);
  known.update({&after}, 0.1, {}, kWalk_mps);
  unknown.update({&after}, 0.1, {}, kWalk_mps);
  EXPECT_GT(nearest(known.frontier()), 2.5);
  EXPECT_LT(nearest(unknown.frontier()), 1.2);
  known.update({&after}, 3.0, {}, kWalk_mps);  // 2.9 m on foot reach everything behind the pillar
  EXPECT_LT(nearest(known.frontier()), 1.2);
}

/** People walk no slower in the grid than they may, and at most two cells ahead of that: a corner
 * seen once, then hidden by a near wall for half a second. */
TEST(HiddenPeople, WalkAtTheirSpeed) {
  HiddenPeopleParameters parameters;
  parameters.outsideView = HiddenPeopleParameters::OutsideView::Remembered;
  const PlanarScan scan = around(corner);
  const PlanarScan blind = around([](double) { return 0.45; });
  HiddenPeople hidden = people(parameters);
  hidden.update({&scan}, 0.0, {}, kWalk_mps);
  const TPoint2D edge{0.3, -2.0};  // seen empty, 0.63 m left of the shadow's edge
  const auto possibleAt = [&hidden](const TPoint2D& p) {
    const CostGrid& grid = hidden.possible();
    return grid.at(grid.cellX(p.x), grid.cellY(p.y)) != 0;
  };
  ASSERT_FALSE(possibleAt(edge));
  double reached_s = 0.0;
  for (double t = 0.1; t < 1.5 && reached_s == 0.0; t += 0.1) {
    hidden.update({&blind}, t, {}, kWalk_mps);
    if (possibleAt(edge)) reached_s = t;
  }
  // The edge of the shadow is the line from the origin through (0.5, −1).
  const double distance = std::abs(0.3 * -1.0 - -2.0 * 0.5) / std::hypot(0.5, 1.0);
  EXPECT_LE(reached_s, distance / kWalk_mps + 0.11);
  EXPECT_GE(reached_s, distance / kWalk_mps - 0.15);
}

/** In all directions alike: into a round room that was seen empty, from all around. Eight
 * directions are 8 % ahead at most, and a cell more. */
TEST(HiddenPeople, WalkAsFastInAllDirections) {
  HiddenPeopleParameters parameters;
  parameters.outsideView = HiddenPeopleParameters::OutsideView::Remembered;
  parameters.reach_m = 8.0;
  constexpr double kRoom_m = 7.0, kWalked_m = 6.0;
  const PlanarScan room = around([](double) { return kRoom_m; });
  const PlanarScan blind = around([](double) { return 0.3; });
  HiddenPeople hidden = people(parameters);
  hidden.update({&room}, 0.0, {}, kWalk_mps);
  for (int k = 1; k <= 60; ++k) hidden.update({&blind}, 0.1 * k, {}, kWalk_mps);
  const CostGrid& grid = hidden.possible();
  for (double angle = 0.0; angle < 2.0 * M_PI; angle += M_PI / 64.0) {
    double reached_m = 0.35;  // outside what is seen now
    const auto possibleAt = [&](double range_m) {
      return grid.at(grid.cellX(range_m * std::cos(angle)), grid.cellY(range_m * std::sin(angle)));
    };
    while (possibleAt(reached_m) == 0) reached_m += 0.01;
    EXPECT_LE(reached_m, kRoom_m - kWalked_m + parameters.resolution_m) << angle;
    EXPECT_GE(reached_m, kRoom_m - 1.083 * kWalked_m - parameters.resolution_m) << angle;
  }
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

/** A board of 1.6 m hides somebody. Seen edge-on, it is still in the way: who stands behind it does
 * not come through. */
TEST(HiddenPeople, DoNotWalkThroughWhatWasSeenToStand) {
  for (const bool remembered : {true, false}) {
    HiddenPeople hidden = people();
    const auto board = [](double angle) {
      const double range = 1.0 / std::cos(angle);
      return std::abs(angle) < 1.0 && std::abs(range * std::sin(angle)) < 0.8 ? range : 3.0;
    };
    const PlanarScan front = around(board);
    hidden.update({&front}, 0.0, {}, kWalk_mps);
    if (remembered) hidden.standing().add({1.0, -0.8}, {1.0, 0.8});
    // From then on nothing is seen ahead.
    std::vector<float> ranges(720, 3.0f);
    for (int i = 360 - 80; i < 360 + 80; ++i) ranges[static_cast<std::size_t>(i)] = test::kLost;
    const PlanarScan beside = test::scanOf(ranges, 2.0 * M_PI * 719 / 720);
    for (int k = 1; k <= 3; ++k) hidden.update({&beside}, 0.1 * k, {}, kWalk_mps);
    EXPECT_EQ(nearest(hidden.frontier()) > 0.85, remembered);
  }
}

/** Between a wall and a board 0.3 m from it, nobody comes out. */
TEST(HiddenPeople, DoNotSlipThroughAGapThatIsTooNarrow) {
  for (const double gap_m : {0.3, 0.7}) {
    HiddenPeople hidden = people();
    const auto view = [gap_m](double angle) {
      const double wall = angle < -0.05 ? -1.0 / std::sin(angle) : 99.0;          // along y = -1
      const double board = std::abs(angle) < 1.3 ? 1.0 / std::cos(angle) : 99.0;  // x = 1
      const bool onBoard = board * std::sin(angle) > -1.0 + gap_m;
      return std::min({3.0, wall, onBoard ? board : 99.0});
    };
    const PlanarScan scan = around(view);
    hidden.update({&scan}, 0.0, {}, kWalk_mps);
    // A cell at the end of the board may be left, where a disc does not reach into the corner.
    if (gap_m < 0.5)
      EXPECT_LE(hidden.frontier().size(), 2u);
    else
      EXPECT_GT(hidden.frontier().size(), 20u);
  }
}

/** A laser with a narrow view: behind it, nobody is assumed, or what was there stays there. Behind
 * the wall that it sees, 3 m away, somebody may be either way. */
TEST(HiddenPeople, OutsideTheViewIsAChoice) {
  const PlanarScan ahead = test::scanOf(std::vector<float>(181, 3.0f), M_PI / 2.0);
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
  const PlanarScan open = test::scanOf(std::vector<float>(181, 3.5f), M_PI / 2.0),
                   blocked = test::scanOf(std::vector<float>(181, 1.5f), M_PI / 2.0);
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
}  // namespace bslnav
