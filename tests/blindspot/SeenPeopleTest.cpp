#include <bslnav/blindspot/SeenPeople.h>
#include <gtest/gtest.h>

#include <algorithm>
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

/** SeenPeople in a place whose map is this. */
class Seen {
 public:
  explicit Seen(const CostGrid& mapped = freeMap())
      : mapped_(mapped), reached_(mapped.width(), mapped.height()) {
    standing_.follow(mapped);
    reached_.invert();  // from anywhere
  }

  /** Somebody unseen can have got to this place only. */
  void reachedOnlyAt(double x_m, double y_m) {
    reached_.clear();
    reached_.set(mapped_.cellX(x_m), mapped_.cellY(y_m));
  }

  void update(const SeenPeople::Views& views, double stamp_s) {
    people_.update(views, stamp_s, {}, {mapped_, standing_, reached_}, kWalk_mps);
  }
  const Frontier& frontier() const { return people_.frontier(); }
  const Movers& movers() const { return people_.movers(); }
  const std::vector<Track>& tracks() const { return people_.tracks(); }

 private:
  CostGrid mapped_;
  StandingThings standing_;
  BitGrid reached_;
  SeenPeople people_{SeenPeopleParameters{}};
};

/** A scan that sees the nearer of two things. */
PlanarScan nearerOf(const PlanarScan& a, const PlanarScan& b) {
  std::vector<float> ranges;
  for (std::size_t k = 0; k < a.beam.size(); ++k) {
    const float inA = a.beam[k] == PlanarScan::Beam::Hit ? a.range_m[k] : 1e3f;
    const float inB = b.beam[k] == PlanarScan::Beam::Hit ? b.range_m[k] : 1e3f;
    ranges.push_back(inA < 1e3f || inB < 1e3f ? std::min(inA, inB) : test::kNone);
  }
  return test::scanOf(ranges);
}

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

/** A board across the view, with the beams of discAt(). */
PlanarScan wallAt(double x, double halfWidth) {
  PlanarScan scan = discAt(2.0, 9.0, 0.1);
  std::vector<float> ranges;
  for (std::size_t k = 0; k < scan.beam.size(); ++k) {
    const double c = scan.cosine[k], s = scan.sine[k];
    const bool hit = c > 0.01 && std::abs(x * s / c) < halfWidth;
    ranges.push_back(hit ? static_cast<float>(x / c) : test::kNone);
  }
  return test::scanOf(ranges);
}

TEST(SeenPeople, WhatIsStraightIsAnObstacleAtOnceAndWhoStandsBesideItIsNot) {
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

/** Whoever walks out of what was taken for an obstacle is somebody after a hand's breadth. */
TEST(SeenPeople, WhoeverLeavesThePlaceOfAnObstacleIsSomebody) {
  Seen people;
  const PlanarScan leg = discAt(1.5, 0.0, 0.08), step = discAt(1.5, 0.35, 0.08);
  for (int k = 0; k < 15; ++k) people.update({{&leg}, {}, {}}, 0.1 * k);
  EXPECT_TRUE(people.frontier().empty());
  people.update({{&step}, {}, {}}, 1.5);
  EXPECT_FALSE(people.frontier().empty());
}

/** A pole of 10 cm is too thin for a person once it has stood for a second. */
TEST(SeenPeople, APoleThatStandsIsAnObstacle) {
  Seen people;
  const PlanarScan scan = discAt(1.0, 0.2, 0.05);
  people.update({{&scan}, {}, {}}, 0.0);
  EXPECT_FALSE(people.frontier().empty());
  for (int k = 1; k <= 11; ++k) people.update({{&scan}, {}, {}}, 0.1 * k);
  EXPECT_TRUE(people.frontier().empty());
}

/** The other side of a parcel that comes into view is not somebody, unless somebody may have come
 * there. */
TEST(SeenPeople, WhatIsNarrowWhereNobodyCanHaveComeIsAnObstacleAtOnce) {
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

/** Its edges lie just within and just beyond what counts as the place of the obstacle that was seen
 * to stand: as a whole it is too narrow for anybody. */
TEST(SeenPeople, TheRestOfANarrowObstacleIsTheObstacle) {
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

/** A hedge: 2 m wide, and nowhere straight. */
TEST(SeenPeople, AWideThingIsAnObstacleAtOnce) {
  Seen people;
  PlanarScan scan = discAt(2.5, -0.8, 0.25);
  for (const double y : {-0.4, 0.0, 0.4, 0.8}) scan = nearerOf(scan, discAt(2.5, y, 0.25));
  people.update({{&scan}, {}, {}}, 0.0);
  EXPECT_TRUE(people.frontier().empty());
}

TEST(SeenPeople, WhatTheMapExplainsIsNobody) {
  CostGrid map = freeMap();
  for (int y = 74; y < 86; ++y)
    for (int x = 113; x < 125; ++x) map.at(x, y) = 255;
  Seen people(map);
  const PlanarScan scan = discAt(2.0, 0.0, 0.25);
  people.update({{&scan}, {}, {}}, 0.0);
  EXPECT_TRUE(people.frontier().empty());
  EXPECT_TRUE(people.tracks().empty());
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

/** It stays an obstacle beside the robot, where the camera does not look, until it moves. */
TEST(SeenPeople, WhatIsLowStaysSoAsLongAsItStands) {
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
TEST(SeenPeople, SomebodyBehindALowThingIsSeenByTheCamera) {
  Seen people;
  const PlanarScan box = discAt(2.0, 0.0, 0.25), tops = topsOf(box, 0.4f);
  const PlanarScan person = discAt(2.4, 0.0, 0.25);
  people.update({{&box}, {&person}, {&tops}}, 0.0);
  ASSERT_FALSE(people.frontier().empty());
  for (const auto& p : people.frontier()) EXPECT_NEAR(std::hypot(p.x_m - 2.4, p.y_m), 0.25, 0.01);
}

/** A parcel of 0.2 m, passed: the side that comes into view is near the one that was seen. */
TEST(SeenPeople, ASmallThingDoesNotWalkWhenItsOtherSideComesIntoView) {
  Seen people;
  const PlanarScan front = discAt(1.0, 0.0, 0.1), side = discAt(1.04, -0.06, 0.1);
  for (int k = 0; k < 15; ++k) people.update({{&front}, {}, {}}, 0.1 * k);
  EXPECT_TRUE(people.frontier().empty());
  for (int k = 15; k < 18; ++k) people.update({{&side}, {}, {}}, 0.1 * k);
  EXPECT_TRUE(people.frontier().empty());
}

TEST(SeenPeople, WhoIsSeenTwiceIsOne) {
  Seen people;
  const PlanarScan scan = discAt(2.0, 0.0, 0.25), again = discAt(2.02, 0.01, 0.25);
  for (int k = 0; k < 5; ++k) people.update({{&scan}, {&again}, {}}, 0.1 * k);
  EXPECT_EQ(people.tracks().size(), 1u);
}

}  // namespace
}  // namespace bslnav
