#include <gtest/gtest.h>

#include "SeenFixture.h"

namespace bslnav::test {
namespace {

bool isAll(const Frontier& frontier, FrontierPoint::Kind kind) {
  return std::all_of(frontier.begin(), frontier.end(),
                     [kind](const FrontierPoint& p) { return p.kind == kind; });
}

TEST(SeenPeople, SomebodyWhoStandsMayAlwaysWalkOff) {
  Seen people;
  const PlanarScan scan = discAt(2.0, 0.0, 0.25);
  for (int k = 0; k < 50; ++k) people.update({{&scan}, {}, {}}, 0.1 * k);
  ASSERT_EQ(people.tracks().size(), 1u);
  ASSERT_FALSE(people.frontier().empty());
  for (const auto& p : people.frontier()) {
    EXPECT_NE(p.kind, FrontierPoint::Kind::Hidden);
    EXPECT_NEAR(std::hypot(p.x_m - 2.0, p.y_m), 0.25, 0.01);
  }
}

/** Of who is covered in part, nobody knows how deep that part is; a pole is no body. */
TEST(SeenPeople, HaveBodiesWhenSeenWhole) {
  Seen alone, covered, thin;
  const PlanarScan person = discAt(2.0, 0.0, 0.25);
  const PlanarScan half = nearerOf(person, discAt(1.0, 0.12, 0.1));
  const PlanarScan pole = discAt(2.0, 0.0, 0.1);
  alone.update({{&person}, {}, {}}, 0.0);
  covered.update({{&half}, {}, {}}, 0.0);
  thin.update({{&pole}, {}, {}}, 0.0);
  ASSERT_EQ(alone.bodies().size(), 1u);
  EXPECT_NEAR(alone.bodies()[0].x, 1.75, 0.01);
  EXPECT_NEAR(alone.bodies()[0].y, 0.0, 0.01);
  EXPECT_FALSE(covered.frontier().empty());
  EXPECT_TRUE(covered.bodies().empty());
  EXPECT_FALSE(thin.frontier().empty());
  EXPECT_TRUE(thin.bodies().empty());
}

TEST(SeenPeople, WhoWalksIsAMover) {
  Seen people;
  for (int k = 0; k < 20; ++k) {
    const PlanarScan scan = discAt(2.0, 1.0 - 0.1 * k, 0.25);  // to the right, at 1 m/s
    people.update({{&scan}, {}, {}}, 0.1 * k);
    EXPECT_EQ(people.movers().empty(), k < 3) << k;  // before that it is too early to tell
  }
  ASSERT_EQ(people.movers().size(), 1u);
  EXPECT_NEAR(people.movers()[0].velocity.y, -1.0, 0.15);
  EXPECT_NEAR(people.movers()[0].position.y, -0.9, 0.15);
}

/** For as long as it takes to count as Standing. */
TEST(SeenPeople, WhoStopsMayWalkOnTheSameWayForAWhile) {
  Seen people;
  for (int k = 0; k < 20; ++k) {
    const PlanarScan scan = discAt(2.0, 1.0 - 0.1 * k, 0.25);
    people.update({{&scan}, {}, {}}, 0.1 * k);
  }
  const PlanarScan still = discAt(2.0, -0.9, 0.25);
  for (int k = 20; k < 60; ++k) {
    people.update({{&still}, {}, {}}, 0.1 * k);
    ASSERT_EQ(people.movers().size(), people.frontier()[0].kind == FrontierPoint::Kind::Seen);
    for (const Mover& mover : people.movers()) EXPECT_NEAR(mover.velocity.y, -1.0, 0.25);
  }
  EXPECT_TRUE(people.movers().empty());
}

/** More and more of somebody who stands behind a corner: that is no walk. */
TEST(SeenPeople, WhoComesIntoViewWithoutAStepIsNoMover) {
  Seen people;
  for (int k = 0; k < 10; ++k) {
    PlanarScan scan = discAt(2.0, 0.0, 0.25);
    const double hidden_rad = 0.12 - 0.06 * k;
    for (std::size_t i = 0; i < scan.beam.size(); ++i)
      if (std::asin(static_cast<double>(scan.sine[i])) > -hidden_rad)
        scan.beam[i] = PlanarScan::Beam::NoReturn;
    people.update({{&scan}, {}, {}}, 0.1 * k);
  }
  for (int k = 10; k < 15; ++k) {
    const PlanarScan scan = discAt(2.0, 0.0, 0.25);
    people.update({{&scan}, {}, {}}, 0.1 * k);
  }
  EXPECT_TRUE(people.movers().empty());
}

/** After three seconds the robot may creep past; a step is enough to be one who walks again. */
TEST(SeenPeople, WhoStandsForAWhileIsStandingUntilTheNextStep) {
  Seen people;
  const PlanarScan scan = discAt(2.0, 0.0, 0.25), further = discAt(2.0, 0.5, 0.25);
  for (int k = 0; k <= 30; ++k) {
    people.update({{&scan}, {}, {}}, 0.1 * k);
    ASSERT_FALSE(people.frontier().empty());
    EXPECT_TRUE(isAll(people.frontier(),
                      k < 30 ? FrontierPoint::Kind::Seen : FrontierPoint::Kind::Standing))
        << k;
  }
  people.update({{&further}, {}, {}}, 3.1);
  EXPECT_TRUE(isAll(people.frontier(), FrontierPoint::Kind::Seen));
}

TEST(SeenPeople, TwoSideBySideAreNoObstacle) {
  Seen people;
  const PlanarScan both = nearerOf(discAt(2.0, 0.24, 0.25), discAt(2.0, -0.24, 0.25));
  for (int k = 0; k < 20; ++k) people.update({{&both}, {}, {}}, 0.1 * k);
  EXPECT_FALSE(people.frontier().empty());
}

/** A leg of somebody who was seen before, where the rest is not seen now. */
TEST(SeenPeople, WhatIsNarrowNearSomebodyWhoWasSeenMayWalk) {
  Seen people;
  const PlanarScan person = discAt(1.5, 0.0, 0.25), none = discAt(1.5, 9.0, 0.1),
                   leg = discAt(1.5, 0.9, 0.08);
  people.update({{&person}, {}, {}}, 0.0);
  people.reachedOnlyAt(-3.0, 0.0);
  for (int k = 1; k < 6; ++k) people.update({{&none}, {}, {}}, 0.1 * k);
  people.update({{&leg}, {}, {}}, 0.6);
  EXPECT_FALSE(people.frontier().empty());
}

/** Of a person behind a wall that ends at y = 0.12 a strip is seen, as narrow as a pole. */
TEST(SeenPeople, WhomAWallHidesInPartMayWalkOffHoweverLongStanding) {
  Seen people;
  PlanarScan scan = discAt(2.0, 0.3, 0.25);
  for (std::size_t k = 0; k < scan.beam.size(); ++k) {
    const double a =
        std::atan2(static_cast<double>(scan.sine[k]), static_cast<double>(scan.cosine[k]));
    if (a < std::atan2(0.12, 1.0) || a > 1.2) continue;
    scan.beam[k] = PlanarScan::Beam::Hit;
    scan.range_m[k] = static_cast<float>(1.0 / std::cos(a));
  }
  for (int k = 0; k < 30; ++k) people.update({{&scan}, {}, {}}, 0.1 * k);
  ASSERT_FALSE(people.frontier().empty());
  for (const auto& p : people.frontier()) EXPECT_GT(p.x_m, 1.5);
}

/** In a narrow door, what is near its sides counts as the map's: too little is left to tell how
 * wide somebody is. */
TEST(SeenPeople, WhoStandsInADoorMayWalkOffHoweverLongStanding) {
  CostGrid map = freeMap();
  for (double x = 1.5; x < 3.0; x += 0.05)
    for (double y = -0.5; y < 0.5; y += 0.05)
      if (std::abs(y) > 0.12) map.at(map.cellX(x), map.cellY(y)) = 255;
  Seen people(map);
  const PlanarScan scan = discAt(2.0, 0.0, 0.25);
  for (int k = 0; k < 30; ++k) people.update({{&scan}, {}, {}}, 0.1 * k);
  EXPECT_FALSE(people.frontier().empty());
}

/** Walking to the left at 1 m/s, seen ten times a second. */
TEST(SeenPeople, AreFollowed) {
  Seen people;
  for (int k = 0; k < 20; ++k) {
    const PlanarScan scan = discAt(2.0, -1.0 + 0.1 * k, 0.25);
    people.update({{&scan}, {}, {}}, 0.1 * k);
  }
  ASSERT_EQ(people.tracks().size(), 1u);
  EXPECT_NEAR(people.tracks()[0].velocity.y, 1.0, 0.1);
  EXPECT_NEAR(people.tracks()[0].velocity.x, 0.0, 0.15);
}

TEST(SeenPeople, WhoIsSeenTwiceIsOne) {
  Seen people;
  const PlanarScan scan = discAt(2.0, 0.0, 0.25), again = discAt(2.02, 0.01, 0.25);
  for (int k = 0; k < 5; ++k) people.update({{&scan}, {&again}, {}}, 0.1 * k);
  EXPECT_EQ(people.tracks().size(), 1u);
}

}  // namespace
}  // namespace bslnav::test
