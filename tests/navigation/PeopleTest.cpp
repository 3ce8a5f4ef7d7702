#include <bslnav/navigation/People.h>
#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <cmath>
#include <optional>

#include "../blindspot/ScanFixture.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

constexpr double kWalk_mps = 1.2, kRoom_m = 3.5;

struct Disc {
  TPoint2D centre;
  double radius_m;
};
const Disc kPillar{{2.6, 0.0}, 0.25};

/** How far it is from within a disc to its edge (`inside`), or from outside to it; kNone: no hit.
 */
float rangeTo(const Disc& disc, const TPoint2D& from, double angle, bool inside) {
  const TPoint2D to = disc.centre - from;
  const double along = to.x * std::cos(angle) + to.y * std::sin(angle);
  const double across = to.y * std::cos(angle) - to.x * std::sin(angle);
  const double half_squared = disc.radius_m * disc.radius_m - across * across;
  if (half_squared <= 0.0) return test::kNone;
  const double range_m = along + (inside ? 1.0 : -1.0) * std::sqrt(half_squared);
  return range_m > 0.0 ? static_cast<float>(range_m) : test::kNone;
}

/** All around, from a place in a round room with a pillar and somebody. */
PlanarScan scanFrom(const TPose2D& pose, const std::optional<TPoint2D>& person) {
  std::vector<float> ranges;
  constexpr int kBeams = 1441;
  for (int i = 0; i < kBeams; ++i) {
    const double angle = pose.phi - M_PI + 2.0 * M_PI * i / (kBeams - 1);
    const TPoint2D from(pose.x, pose.y);
    float range_m =
        std::min(rangeTo({{}, kRoom_m}, from, angle, true), rangeTo(kPillar, from, angle, false));
    if (person) range_m = std::min(range_m, rangeTo({*person, 0.25}, from, angle, false));
    ranges.push_back(range_m);
  }
  return test::scanOf(ranges, 2.0 * M_PI);
}

/** The pillar alone: nobody is in it. */
std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> map() {
  auto grid = std::make_shared<mrpt::maps::COccupancyGridMap2D>(-5.0f, 5.0f, -5.0f, 5.0f, 0.05f);
  grid->fill(1.0f);
  for (double x = -0.25; x <= 0.25; x += 0.05)
    for (double y = -0.25; y <= 0.25; y += 0.05)
      if (std::hypot(x, y) <= kPillar.radius_m)
        grid->setPos(static_cast<float>(kPillar.centre.x + x),
                     static_cast<float>(kPillar.centre.y + y), 0.0f);
  return grid;
}

/** How near to a place the frontier comes. */
double nearest(const Frontier& frontier, const TPoint2D& to) {
  double least = 1e9;
  for (const auto& p : frontier) least = std::min(least, std::hypot(p.x_m - to.x, p.y_m - to.y));
  return least;
}

/** Nobody was behind the pillar, until somebody walks there before the robot's eyes, along the
 * wall: there is no room for anybody else behind him. */
TEST(People, WhoWalksBehindSomethingMayBeThere) {
  const TPose2D front, right{2.0, -2.0, M_PI / 2.0}, left{2.0, 2.0, -M_PI / 2.0};
  const auto onWay = [](double angle) {
    return TPoint2D(3.2 * std::cos(angle), 3.2 * std::sin(angle));
  };
  People people({}, {}, 0.25, map(), {});
  double time_s = 0.0;
  const auto see = [&](const TPose2D& pose, double angle) {
    const std::vector<PlanarScan> lasers{scanFrom(pose, onWay(angle))};
    people.update({lasers, {}, {}}, time_s += 0.1, pose, kWalk_mps);
  };
  constexpr double kStart = 0.5;
  for (const TPose2D& pose : {front, right, left, front, front}) see(pose, kStart);
  EXPECT_GT(nearest(people.frontier(), onWay(0.0)), 0.6);
  for (int k = 0; k <= 16; ++k) see(front, kStart * (1.0 - k / 16.0));  // at 1 m/s
  for (int k = 0; k < 20; ++k) see(front, 0.0);
  EXPECT_LT(nearest(people.frontier(), onWay(0.0)), 0.6);
}

/** However little of them is in view at first, and though nobody is assumed where no sensor looks.
 */
TEST(People, WhoComesInAtTheEdgeOfTheViewIsSeenAtOnce) {
  People people({}, {}, 0.25, nullptr, {});
  for (int k = 0; k < 30; ++k) {
    const Disc person{{2.0, -2.4 + 0.1 * k}, 0.25};  // at 1 m/s
    std::vector<float> ranges;
    for (int i = 0; i <= 180; ++i)
      ranges.push_back(rangeTo(person, {}, M_PI / 2.0 * (i / 180.0 - 0.5), false));
    const std::vector<PlanarScan> lasers{test::scanOf(ranges, M_PI / 2.0)};
    people.update({lasers, {}, {}}, 0.1 * k, {}, kWalk_mps);
    if (lasers[0].hits() == 0) continue;
    EXPECT_LT(nearest(people.frontier(), person.centre), 0.35) << k;
  }
}

}  // namespace
}  // namespace bslnav
