// How those who are hidden walk on, and what is remembered of where they are not.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "HiddenFixture.h"

namespace bslnav::test {
namespace {

using mrpt::math::TPoint2D;

constexpr double kWalk_mps = 1.0;

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
    for (int i = 360 - 80; i < 360 + 80; ++i) ranges[static_cast<std::size_t>(i)] = kLost;
    const PlanarScan beside = scanOf(ranges, 2.0 * M_PI * 719 / 720);
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

}  // namespace
}  // namespace bslnav::test
