#include <bslnav/planning/PathDistance.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "DwaGenerators.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using test::any;

constexpr double kAll_m = 1e6;

/** A walk of up to 30 corners, up to 0.3 m apart, some of them on the same spot. */
std::vector<TPoint2D> anyPath() {
  std::vector<TPoint2D> path{{any(-3.0, 3.0), any(-3.0, 3.0)}};
  for (int n = *rc::gen::inRange(0, 30); n > 0; --n) {
    const double step = *rc::gen::element(0.0, 0.2), turn = any(-M_PI, M_PI);
    path.push_back(path.back() + TPoint2D{step * std::cos(turn), step * std::sin(turn)});
  }
  return path;
}

double bruteForce(const std::vector<TPoint2D>& path, const TPoint2D& p) {
  double nearest = (path.front() - p).norm();
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const TPoint2D a = path[i], ab = path[i + 1] - a;
    const double t =
        ab.sqrNorm() > 0.0
            ? std::clamp(((p - a).x * ab.x + (p - a).y * ab.y) / ab.sqrNorm(), 0.0, 1.0)
            : 0.0;
    nearest = std::min(nearest, (a + ab * t - p).norm());
  }
  return nearest;
}

RC_GTEST_PROP(PathDistanceLaw, OfTheWholePathIsThatOfBruteForce, ()) {
  const auto path = anyPath();
  const TPoint2D robot{any(-3.0, 3.0), any(-3.0, 3.0)}, p{any(-4.0, 4.0), any(-4.0, 4.0)};
  PathDistance distance;
  distance.setPath(path, robot, kAll_m, kAll_m, 0.0);
  RC_ASSERT(std::abs(distance(p) - bruteForce(path, p)) < 1e-5);
}

RC_GTEST_PROP(PathDistanceLaw, OfCornersFartherApartIsWrongByNoMoreThanTheirSpacing, ()) {
  const auto path = anyPath();
  const TPoint2D p{any(-4.0, 4.0), any(-4.0, 4.0)};
  PathDistance distance;
  distance.setPath(path, path.front(), kAll_m, kAll_m, 0.1);
  RC_ASSERT(std::abs(distance(p) - bruteForce(path, p)) <= 0.1 + 0.2);  // a step may end 0.2 m on
}

TEST(PathDistance, TakesOnlyThePartNearTheRobot) {
  PathDistance distance;
  distance.setPath(test::straightPath(10.0), {5.0, 0.3}, 1.0, 2.0, 0.1);
  EXPECT_NEAR(distance({3.5, 0.0}), 0.5, 0.051);  // the part begins at x = 4, to one point
  EXPECT_NEAR(distance({8.0, 0.0}), 1.0, 0.051);  // and ends at x = 7
  EXPECT_NEAR(distance({6.0, -0.25}), 0.25, 1e-6);
}

TEST(PathDistance, IsZeroWithoutAPath) {
  PathDistance distance;
  distance.setPath(test::straightPath(1.0), {}, 1.0, 1.0, 0.1);
  distance.setPath({}, {}, 1.0, 1.0, 0.1);
  EXPECT_EQ(distance({3.0, 4.0}), 0.0);
}

TEST(PathDistance, OfASinglePointIsTheDistanceToIt) {
  PathDistance distance;
  distance.setPath({{1.0, 1.0}}, {}, 1.0, 1.0, 0.1);
  EXPECT_DOUBLE_EQ(distance({4.0, 5.0}), 5.0);
}

TEST(PointAhead, LiesThatFarAlongThePathOrAtItsEnd) {
  const std::vector<TPoint2D> path{{0.0, 0.0}, {1.0, 0.0}, {1.0, 2.0}};
  EXPECT_EQ(pointAhead(path, {0.1, 0.1}, 1.5), (TPoint2D{1.0, 0.5}));
  EXPECT_EQ(pointAhead(path, {0.1, 0.1}, 9.0), (TPoint2D{1.0, 2.0}));
}

TEST(NearestIndex, SearchesFromAnIndexOn) {
  const std::vector<TPoint2D> path{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}};
  EXPECT_EQ(nearestIndex(path, {0.2, 0.0}), 0u);
  EXPECT_EQ(nearestIndex(path, {0.2, 0.0}, 1), 1u);
  EXPECT_EQ(nearestIndex(path, {0.2, 0.0}, 99), 2u);
}

}  // namespace
}  // namespace bslnav
