#include <bslnav/blindspot/SeenPeople.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ScanFixture.h"

namespace bslnav {
namespace {

constexpr double kWalk_mps = 1.2;

/** 180 beams ahead, no return but for a disc at (x, y). */
PlanarScan discAt(double x, double y, double radius) {
  std::vector<float> ranges;
  constexpr int kBeams = 361;
  for (int i = 0; i < kBeams; ++i) {
    const double a = -M_PI / 2.0 + M_PI * i / (kBeams - 1);
    const double along = x * std::cos(a) + y * std::sin(a),
                 across = y * std::cos(a) - x * std::sin(a);
    const bool hit = along > 0.0 && std::abs(across) < radius;
    ranges.push_back(hit ? static_cast<float>(along - std::sqrt(radius * radius - across * across))
                         : test::kNone);
  }
  return test::scanOf(ranges);
}

CostGrid freeMap() { return CostGrid(160, 160, 0.05, -4.0, -4.0, 0); }

TEST(SeenPeople, SomebodyWhoStandsMayAlwaysWalkOff) {
  SeenPeople people({});
  const PlanarScan scan = discAt(2.0, 0.0, 0.25);
  for (int k = 0; k < 50; ++k) people.update({{&scan}, {}, {}}, 0.1 * k, {}, freeMap(), kWalk_mps);
  ASSERT_EQ(people.tracks().size(), 1u);
  ASSERT_FALSE(people.frontier().empty());
  for (const auto& p : people.frontier()) {
    EXPECT_EQ(p.kind, FrontierPoint::Kind::Seen);
    EXPECT_NEAR(std::hypot(p.x_m - 2.0, p.y_m), 0.25, 0.01);
  }
}

TEST(SeenPeople, WhoWalksIsAMoverAndWhoStandsIsNone) {
  SeenPeople people({});
  for (int k = 0; k < 20; ++k) {
    const PlanarScan scan = discAt(2.0, 1.0 - 0.1 * k, 0.25);  // to the right, at 1 m/s
    people.update({{&scan}, {}, {}}, 0.1 * k, {}, freeMap(), kWalk_mps);
    EXPECT_EQ(people.movers().empty(), k < 3) << k;  // before that it is too early to tell
  }
  ASSERT_EQ(people.movers().size(), 1u);
  EXPECT_NEAR(people.movers()[0].velocity.y, -1.0, 0.15);
  EXPECT_NEAR(people.movers()[0].position.y, -0.9, 0.15);
  const PlanarScan still = discAt(2.0, -0.9, 0.25);
  for (int k = 20; k < 30; ++k)
    people.update({{&still}, {}, {}}, 0.1 * k, {}, freeMap(), kWalk_mps);
  EXPECT_TRUE(people.movers().empty());
}

TEST(SeenPeople, WhoStandsAHandAwayFromSomethingWideIsStillAPerson) {
  SeenPeople people({});
  const PlanarScan wide = discAt(2.5, 0.9, 0.6), person = discAt(2.5, -0.2, 0.25);
  std::vector<float> ranges;
  for (int i = 0; i < wide.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool ofWide = wide.beam[k] == PlanarScan::Beam::Hit;
    ranges.push_back((ofWide ? wide : person).range_m[k]);
    if (!ofWide && person.beam[k] != PlanarScan::Beam::Hit) ranges.back() = test::kNone;
  }
  const PlanarScan both = test::scanOf(ranges);
  for (int k = 0; k < 5; ++k) people.update({{&both}, {}, {}}, 0.1 * k, {}, freeMap(), kWalk_mps);
  ASSERT_FALSE(people.frontier().empty());
  for (const auto& p : people.frontier()) EXPECT_LT(p.y_m, 0.1);
}

/** A pole of 10 cm is too thin for a person once it has stood for a second. */
TEST(SeenPeople, APoleThatStandsIsAnObstacle) {
  SeenPeople people({});
  const PlanarScan scan = discAt(1.0, 0.2, 0.05);
  people.update({{&scan}, {}, {}}, 0.0, {}, freeMap(), kWalk_mps);
  EXPECT_FALSE(people.frontier().empty());
  for (int k = 1; k <= 11; ++k) people.update({{&scan}, {}, {}}, 0.1 * k, {}, freeMap(), kWalk_mps);
  EXPECT_TRUE(people.frontier().empty());
}

/** Of a person behind a wall that ends at y = 0.12 a strip is seen, as narrow as a pole. */
TEST(SeenPeople, WhomAWallHidesInPartMayWalkOffHoweverLongStanding) {
  SeenPeople people({});
  PlanarScan scan = discAt(2.0, 0.3, 0.25);
  for (std::size_t k = 0; k < scan.beam.size(); ++k) {
    const double a =
        std::atan2(static_cast<double>(scan.sine[k]), static_cast<double>(scan.cosine[k]));
    if (a < std::atan2(0.12, 1.0) || a > 1.2) continue;
    scan.beam[k] = PlanarScan::Beam::Hit;
    scan.range_m[k] = static_cast<float>(1.0 / std::cos(a));
  }
  for (int k = 0; k < 30; ++k) people.update({{&scan}, {}, {}}, 0.1 * k, {}, freeMap(), kWalk_mps);
  ASSERT_FALSE(people.frontier().empty());
  for (const auto& p : people.frontier()) EXPECT_GT(p.x_m, 1.5);
}

/** In a narrow door, what is within 0.1 m of its sides counts as the map's: too little is left to
 * tell how wide somebody is. */
TEST(SeenPeople, WhoStandsInADoorMayWalkOffHoweverLongStanding) {
  SeenPeople people({});
  CostGrid map = freeMap();
  for (const double y : {-0.3, 0.3})
    for (double x = 1.5; x < 3.0; x += 0.05) map.at(map.cellX(x), map.cellY(y)) = 255;
  const PlanarScan scan = discAt(2.0, 0.0, 0.25);
  for (int k = 0; k < 30; ++k) people.update({{&scan}, {}, {}}, 0.1 * k, {}, map, kWalk_mps);
  EXPECT_FALSE(people.frontier().empty());
}

TEST(SeenPeople, AWideThingIsAnObstacleAtOnce) {
  SeenPeople people({});
  const PlanarScan scan = discAt(2.5, 0.0, 0.6);
  people.update({{&scan}, {}, {}}, 0.0, {}, freeMap(), kWalk_mps);
  EXPECT_TRUE(people.frontier().empty());
}

TEST(SeenPeople, WhatTheMapExplainsIsNobody) {
  CostGrid map = freeMap();
  for (int y = 75; y < 85; ++y)
    for (int x = 115; x < 125; ++x) map.at(x, y) = 255;
  SeenPeople people({});
  const PlanarScan scan = discAt(2.0, 0.0, 0.25);
  people.update({{&scan}, {}, {}}, 0.0, {}, map, kWalk_mps);
  EXPECT_TRUE(people.frontier().empty());
  EXPECT_TRUE(people.tracks().empty());
}

/** Walking to the left at 1 m/s, seen ten times a second. */
TEST(SeenPeople, AreFollowed) {
  SeenPeople people({});
  for (int k = 0; k < 20; ++k) {
    const PlanarScan scan = discAt(2.0, -1.0 + 0.1 * k, 0.25);
    people.update({{&scan}, {}, {}}, 0.1 * k, {}, freeMap(), kWalk_mps);
  }
  ASSERT_EQ(people.tracks().size(), 1u);
  EXPECT_TRUE(people.tracks()[0].hasMoved);
  EXPECT_NEAR(people.tracks()[0].velocity.y, 1.0, 0.1);
  EXPECT_NEAR(people.tracks()[0].velocity.x, 0.0, 0.15);
}

/** What a depth camera at 0.6 m, whose rays rise by `steepest` per metre, tells of the same disc.
 */
PlanarScan topsOf(PlanarScan scan, float top_m, float steepest = 0.3f) {
  scan.sensorHeight_m = 0.6;
  scan.steepest.assign(scan.beam.size(), steepest);
  scan.top_m.assign(scan.beam.size(), top_m);
  return scan;
}

TEST(SeenPeople, WhatACameraSeesToBeLowIsNobody) {
  const PlanarScan scan = discAt(2.0, 0.0, 0.25);
  const auto isSomebody = [&scan](const PlanarScan& tops) {
    SeenPeople people({});
    people.update({{&scan}, {}, {&tops}}, 0.0, {}, freeMap(), kWalk_mps);
    return !people.frontier().empty();
  };
  EXPECT_FALSE(isSomebody(topsOf(scan, 0.5f)));
  EXPECT_TRUE(isSomebody(topsOf(scan, 0.9f)));
  EXPECT_TRUE(isSomebody(topsOf(scan, 0.6f, 0.0f)));               // no ray is as high as 0.8 m
  EXPECT_TRUE(isSomebody(topsOf(discAt(2.0, 0.4, 0.25), 0.5f)));   // a part alone
  EXPECT_TRUE(isSomebody(topsOf(discAt(2.0, -1.0, 0.25), 0.5f)));  // something else
}

/** It stays an obstacle beside the robot, where the camera does not look, until it moves. */
TEST(SeenPeople, WhatIsLowStaysSoAsLongAsItStands) {
  SeenPeople people({});
  const PlanarScan scan = discAt(2.0, 0.0, 0.25), moved = discAt(2.0, 0.4, 0.25);
  const PlanarScan tops = topsOf(scan, 0.5f);
  people.update({{&scan}, {}, {&tops}}, 0.0, {}, freeMap(), kWalk_mps);
  people.update({{&scan}, {}, {}}, 0.1, {}, freeMap(), kWalk_mps);
  EXPECT_TRUE(people.frontier().empty());
  people.update({{&moved}, {}, {}}, 0.2, {}, freeMap(), kWalk_mps);
  EXPECT_FALSE(people.frontier().empty());
}

/** The laser meets a box, the camera sees over it and meets somebody 0.2 m behind. */
TEST(SeenPeople, SomebodyBehindALowThingIsSeenByTheCamera) {
  SeenPeople people({});
  const PlanarScan box = discAt(2.0, 0.0, 0.25), tops = topsOf(box, 0.4f);
  const PlanarScan person = discAt(2.4, 0.0, 0.25);
  people.update({{&box}, {&person}, {&tops}}, 0.0, {}, freeMap(), kWalk_mps);
  ASSERT_FALSE(people.frontier().empty());
  for (const auto& p : people.frontier()) EXPECT_NEAR(std::hypot(p.x_m - 2.4, p.y_m), 0.25, 0.01);
}

/** A parcel of 0.2 m, passed: the middle of the side that is seen first is 0.14 m from that of the
 * next one. */
TEST(SeenPeople, ASmallThingDoesNotWalkWhenItsOtherSideComesIntoView) {
  SeenPeople people({});
  const PlanarScan front = discAt(1.0, 0.0, 0.1), side = discAt(1.1, -0.1, 0.1);
  for (int k = 0; k < 15; ++k) people.update({{&front}, {}, {}}, 0.1 * k, {}, freeMap(), kWalk_mps);
  EXPECT_TRUE(people.frontier().empty());
  for (int k = 15; k < 18; ++k) people.update({{&side}, {}, {}}, 0.1 * k, {}, freeMap(), kWalk_mps);
  EXPECT_TRUE(people.frontier().empty());
}

TEST(SeenPeople, WhoIsSeenTwiceIsOne) {
  SeenPeople people({});
  const PlanarScan scan = discAt(2.0, 0.0, 0.25), again = discAt(2.02, 0.01, 0.25);
  for (int k = 0; k < 5; ++k)
    people.update({{&scan}, {&again}, {}}, 0.1 * k, {}, freeMap(), kWalk_mps);
  EXPECT_EQ(people.tracks().size(), 1u);
}

}  // namespace
}  // namespace bslnav
