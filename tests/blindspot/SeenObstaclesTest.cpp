// What SeenPeople takes for an obstacle.
#include <gtest/gtest.h>

#include "SeenFixture.h"

namespace bslnav::test {
namespace {

/** A board across the view, with the beams of discAt(). */
PlanarScan wallAt(double x, double halfWidth) {
  PlanarScan scan = discAt(2.0, 9.0, 0.1);
  std::vector<float> ranges;
  for (std::size_t k = 0; k < scan.beam.size(); ++k) {
    const double c = scan.cosine[k], s = scan.sine[k];
    const bool hit = c > 0.01 && std::abs(x * s / c) < halfWidth;
    ranges.push_back(hit ? static_cast<float>(x / c) : kNone);
  }
  return scanOf(ranges);
}

TEST(SeenObstacles, WhatIsStraightIsAnObstacleAtOnceAndWhoStandsBesideItIsNot) {
  Seen people;
  const PlanarScan board = wallAt(2.0, 0.3);
  people.update({{&board}, {}, {}}, 0.0);
  EXPECT_TRUE(people.frontier().empty());
  const PlanarScan beside = nearerOf(board, discAt(2.0, 0.57, 0.25));
  for (int k = 1; k < 20; ++k) {
    people.update({{&beside}, {}, {}}, 0.1 * k);
    ASSERT_FALSE(people.frontier().empty()) << k;
    for (const auto& p : people.frontier()) EXPECT_GT(p.y_m, 0.25);
  }
}

/** Their hits lie on a line over 0.4 m for a moment, and are of no wall. */
TEST(SeenObstacles, PeopleWhoWalkPastEachOtherAreNone) {
  Seen people;
  for (int k = 0; k < 17; ++k) {
    const double walked_m = 0.1 * k;
    const PlanarScan scan =
        nearerOf(discAt(1.24, 0.8 - walked_m, 0.25), discAt(1.02, walked_m - 0.59, 0.25));
    people.update({{&scan}, {}, {}}, walked_m);  // at 1 m/s
    const auto hits = std::count(scan.beam.begin(), scan.beam.end(), PlanarScan::Beam::Hit);
    EXPECT_EQ(people.frontier().size(), static_cast<std::size_t>(hits)) << k;
  }
}

/** Whoever walks out of what was taken for an obstacle is somebody after a hand's breadth. */
TEST(SeenObstacles, WhoeverLeavesThePlaceOfAnObstacleIsSomebody) {
  Seen people;
  const PlanarScan leg = discAt(1.5, 0.0, 0.08), step = discAt(1.5, 0.35, 0.08);
  for (int k = 0; k < 15; ++k) people.update({{&leg}, {}, {}}, 0.1 * k);
  EXPECT_TRUE(people.frontier().empty());
  people.update({{&step}, {}, {}}, 1.5);
  EXPECT_FALSE(people.frontier().empty());
}

/** A pole of 10 cm is too thin for a person once it has stood for a second. */
TEST(SeenObstacles, APoleThatStandsIsAnObstacle) {
  Seen people;
  const PlanarScan scan = discAt(1.0, 0.2, 0.05);
  people.update({{&scan}, {}, {}}, 0.0);
  EXPECT_FALSE(people.frontier().empty());
  for (int k = 1; k <= 11; ++k) people.update({{&scan}, {}, {}}, 0.1 * k);
  EXPECT_TRUE(people.frontier().empty());
}

/** The other side of a parcel that comes into view is not somebody, unless somebody may have come
 * there. */
TEST(SeenObstacles, WhatIsNarrowWhereNobodyCanHaveComeIsAnObstacleAtOnce) {
  const PlanarScan pole = discAt(1.0, 0.2, 0.05), person = discAt(1.0, 0.2, 0.25);
  Seen far, near, wide;
  far.reachedOnlyAt(2.5, 0.2);
  far.update({{&pole}, {}, {}}, 0.0);
  EXPECT_TRUE(far.frontier().empty());
  near.reachedOnlyAt(1.2, 0.2);
  near.update({{&pole}, {}, {}}, 0.0);
  EXPECT_FALSE(near.frontier().empty());
  wide.reachedOnlyAt(2.5, 0.2);
  wide.update({{&person}, {}, {}}, 0.0);
  EXPECT_FALSE(wide.frontier().empty());
}

/** Whoever is in the next room is not beside a board on this side of the wall; where nothing stands
 * yet, the wall may have a door by now. */
TEST(SeenObstacles, WhoeverIsBehindAWallHasNotComeThroughItBesideAnObstacle) {
  const PlanarScan board = wallAt(1.0, 0.2), strip = discAt(1.0, 0.4, 0.05);
  CostGrid wall = freeMap();  // at x = 1.1 m
  for (int y = 0; y < wall.height(); ++y) wall.at(wall.cellX(1.1), y) = 255;
  const auto isSomebody = [&](double reached_m, bool hasBoard) {
    Seen people(freeMap(), wall);
    people.reachedOnlyAt(reached_m, 0.4);
    if (hasBoard) people.update({{&board}, {}, {}}, 0.0);
    people.update({{&strip}, {}, {}}, 0.1);
    return !people.frontier().empty();
  };
  EXPECT_FALSE(isSomebody(1.2, true));
  EXPECT_TRUE(isSomebody(0.8, true));
  EXPECT_TRUE(isSomebody(1.2, false));
}

/** The far end of the side of a box, which stands at a wall: a single beam meets it first, 0.5 m
 * from the front. */
TEST(SeenObstacles, TheFarEndOfASideIsOfTheSameBox) {
  const PlanarScan front = wallAt(1.0, 0.2), side = discAt(1.55, 0.3, 0.05);
  CostGrid wall = freeMap();
  for (int y = 0; y < wall.height(); ++y) wall.at(wall.cellX(1.65), y) = 255;
  const auto isSomebody = [&](double reached_m) {
    Seen people(freeMap(), wall);
    people.reachedOnlyAt(reached_m, 0.3);
    people.update({{&front}, {}, {}}, 0.0);
    people.update({{&side}, {}, {}}, 0.1);
    return !people.frontier().empty();
  };
  EXPECT_FALSE(isSomebody(1.75));  // in the next room
  EXPECT_TRUE(isSomebody(1.3));
}

/** A strip of something beside a nearer pole: a person goes on behind that, or past the view. */
TEST(SeenObstacles, WhatIsCoveredIsOneWhereNobodyCanBeBehindIt) {
  const PlanarScan scan = nearerOf(discAt(2.0, 0.3, 0.15), discAt(1.0, 0.08, 0.05));
  const auto isSomebody = [&scan](double reached_m, bool hasBlindSide) {
    Seen people;
    people.reachedOnlyAt(reached_m, 0.3);
    if (hasBlindSide) people.haveBlindSide();
    people.update({{&scan}, {}, {}}, 0.0);
    return std::any_of(people.frontier().begin(), people.frontier().end(),
                       [](const FrontierPoint& p) { return p.x_m > 1.5; });
  };
  EXPECT_TRUE(isSomebody(2.7, false));
  EXPECT_FALSE(isSomebody(-3.0, false));
  EXPECT_TRUE(isSomebody(-3.0, true));
}

/** Its edges lie just within and just beyond what counts as the place of the obstacle that was seen
 * to stand: as a whole it is too narrow for anybody. */
TEST(SeenObstacles, TheRestOfANarrowObstacleIsTheObstacle) {
  Seen people;
  const PlanarScan small = discAt(1.0, 0.0, 0.05), all = discAt(1.0, 0.1, 0.15);
  for (int k = 0; k <= 11; ++k) people.update({{&small}, {}, {}}, 0.1 * k);
  ASSERT_TRUE(people.frontier().empty());
  people.reachedOnlyAt(-3.0, 0.0);
  people.update({{&all}, {}, {}}, 1.2);
  EXPECT_TRUE(people.frontier().empty());
  const PlanarScan somebody = nearerOf(small, discAt(1.0, 0.3, 0.25));
  people.update({{&somebody}, {}, {}}, 1.3);
  EXPECT_FALSE(people.frontier().empty());
}

/** A hedge: 2 m wide, and nowhere straight. */
TEST(SeenObstacles, AWideThingIsAnObstacleAtOnce) {
  Seen people;
  PlanarScan scan = discAt(2.5, -0.8, 0.25);
  for (const double y : {-0.4, 0.0, 0.4, 0.8}) scan = nearerOf(scan, discAt(2.5, y, 0.25));
  people.update({{&scan}, {}, {}}, 0.0);
  EXPECT_TRUE(people.frontier().empty());
}

TEST(SeenObstacles, WhatTheMapExplainsIsNobody) {
  CostGrid map = freeMap();
  for (int y = 74; y < 86; ++y)
    for (int x = 113; x < 125; ++x) map.at(x, y) = 255;
  Seen people(map);
  const PlanarScan scan = discAt(2.0, 0.0, 0.25);
  people.update({{&scan}, {}, {}}, 0.0);
  EXPECT_TRUE(people.frontier().empty());
  EXPECT_TRUE(people.tracks().empty());
}

/** What a depth camera at 0.6 m, whose rays rise by `steepest` per metre, tells of the same disc.
 */
PlanarScan topsOf(PlanarScan scan, float top_m, float steepest = 0.3f) {
  scan.sensorHeight_m = 0.6;
  scan.steepest.assign(scan.beam.size(), steepest);
  scan.top_m.assign(scan.beam.size(), top_m);
  return scan;
}

TEST(SeenObstacles, WhatACameraSeesToBeLowIsNobody) {
  const PlanarScan scan = discAt(2.0, 0.0, 0.25);
  const auto isSomebody = [&scan](const PlanarScan& tops) {
    Seen people;
    people.update({{&scan}, {}, {&tops}}, 0.0);
    return !people.frontier().empty();
  };
  EXPECT_FALSE(isSomebody(topsOf(scan, 0.5f)));
  EXPECT_TRUE(isSomebody(topsOf(scan, 0.9f)));
  EXPECT_TRUE(isSomebody(topsOf(scan, 0.6f, 0.0f)));               // no ray is as high as 0.8 m
  EXPECT_TRUE(isSomebody(topsOf(discAt(2.0, 0.4, 0.25), 0.5f)));   // a part alone
  EXPECT_TRUE(isSomebody(topsOf(discAt(2.0, -1.0, 0.25), 0.5f)));  // something else
}

/** A column of pixels beside somebody's edge meets some of the height only. */
TEST(SeenObstacles, TheEdgeOfASilhouetteTellsNoHeight) {
  const PlanarScan strip = discAt(2.0, 0.0, 0.009);  // one beam
  const PlanarScan edge = topsOf(strip, 0.5f), low = topsOf(discAt(2.0, 0.0, 0.1), 0.5f);
  Seen somebody, parcel;
  somebody.update({{&strip}, {}, {&edge}}, 0.0);
  parcel.update({{&strip}, {}, {&low}}, 0.0);
  EXPECT_FALSE(somebody.frontier().empty());
  EXPECT_TRUE(parcel.frontier().empty());
}

/** It stays an obstacle beside the robot, where the camera does not look, until it moves. */
TEST(SeenObstacles, WhatIsLowStaysSoAsLongAsItStands) {
  Seen people;
  const PlanarScan scan = discAt(2.0, 0.0, 0.25), moved = discAt(2.0, 0.4, 0.25);
  const PlanarScan tops = topsOf(scan, 0.5f);
  people.update({{&scan}, {}, {&tops}}, 0.0);
  people.update({{&scan}, {}, {}}, 0.1);
  EXPECT_TRUE(people.frontier().empty());
  people.update({{&moved}, {}, {}}, 0.2);
  EXPECT_FALSE(people.frontier().empty());
}

/** The laser meets a box, the camera sees over it and meets somebody 0.2 m behind. */
TEST(SeenObstacles, SomebodyBehindALowThingIsSeenByTheCamera) {
  Seen people;
  const PlanarScan box = discAt(2.0, 0.0, 0.25), tops = topsOf(box, 0.4f);
  const PlanarScan person = discAt(2.4, 0.0, 0.25);
  people.update({{&box}, {&person}, {&tops}}, 0.0);
  ASSERT_FALSE(people.frontier().empty());
  for (const auto& p : people.frontier()) EXPECT_NEAR(std::hypot(p.x_m - 2.4, p.y_m), 0.25, 0.01);
}

/** A parcel of 0.2 m, passed: the side that comes into view is near the one that was seen. */
TEST(SeenObstacles, ASmallThingDoesNotWalkWhenItsOtherSideComesIntoView) {
  Seen people;
  const PlanarScan front = discAt(1.0, 0.0, 0.1), side = discAt(1.04, -0.06, 0.1);
  for (int k = 0; k < 15; ++k) people.update({{&front}, {}, {}}, 0.1 * k);
  EXPECT_TRUE(people.frontier().empty());
  for (int k = 15; k < 18; ++k) people.update({{&side}, {}, {}}, 0.1 * k);
  EXPECT_TRUE(people.frontier().empty());
}

}  // namespace
}  // namespace bslnav::test
