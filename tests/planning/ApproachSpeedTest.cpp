#include <bslnav/planning/ApproachSpeed.h>
#include <gtest/gtest.h>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

constexpr double kHighest_mps = 0.6;

/** Of a robot of 0.25 m at the origin that looks along its path, 5 m along x; somebody's way is
 * taken to be 0.6 m to each side. */
double speed_mps(const std::vector<TPoint2D>& people, const Movers& movers = {},
                 const mrpt::math::TPose2D& pose = {}, double share = 0.5) {
  std::vector<TPoint2D> path;
  for (int i = 0; i <= 100; ++i) path.emplace_back(0.05 * i, 0.0);
  MoverParameters parameters;
  parameters.approachShare = share;
  return ApproachSpeed(parameters, {0.25, 0.5, 0.2}, 1.1, kHighest_mps)
      .speed_mps({people, movers}, path, pose);
}

TEST(ApproachSpeed, IsTheHighestWhereNobodyMayCross) {
  EXPECT_EQ(speed_mps({}), kHighest_mps);
  EXPECT_EQ(speed_mps({{0.7, 3.5}}), kHighest_mps);   // too far away to be there in time
  EXPECT_EQ(speed_mps({{2.0, -1.5}}), kHighest_mps);  // the robot is not there for long
  EXPECT_EQ(speed_mps({{-0.5, -1.5}}), kHighest_mps);
}

TEST(ApproachSpeed, IsHalfOfThatWhereTheirWayBegins) {
  EXPECT_DOUBLE_EQ(speed_mps({{0.61, -1.5}}), 0.5 * kHighest_mps);
  EXPECT_DOUBLE_EQ(speed_mps({{0.61, 1.5}}), 0.5 * kHighest_mps);
  EXPECT_EQ(speed_mps({{0.61, 1.5}}, {}, {}, 1.0), kHighest_mps);
}

/** From 0.6 m/s it takes 0.36 m to stand, from half of that 0.09 m, and 0.2 s to begin with. */
TEST(ApproachSpeed, FallsOnTheWayThere) {
  const double far = speed_mps({{0.9, -1.5}}), near = speed_mps({{0.8, -1.5}});
  EXPECT_GT(far, near);
  EXPECT_LT(far, kHighest_mps);
  EXPECT_GT(near, 0.5 * kHighest_mps);
}

/** In their way, the sooner it is through the better. */
TEST(ApproachSpeed, IsTheHighestInTheirWay) { EXPECT_EQ(speed_mps({{0.59, -1.5}}), kHighest_mps); }

TEST(ApproachSpeed, LeavesThoseWhoWalkToTheForecast) {
  EXPECT_EQ(speed_mps({{0.7, -1.5}}, {{{0.8, -1.6}, {0.0, 1.0}}}), kHighest_mps);
  EXPECT_LT(speed_mps({{0.7, -1.5}}, {{{2.8, -1.6}, {0.0, 1.0}}}), kHighest_mps);
}

/** The robot looks 30 degrees to the left of its path, away from somebody at its right: where they
 * cross by its heading begins earlier, by its path later. */
TEST(ApproachSpeed, IsLowUntilTheRobotIsInTheirWayEitherWay) {
  const mrpt::math::TPose2D aside{0.0, 0.0, 0.5};
  EXPECT_DOUBLE_EQ(speed_mps({{0.9, -1.0}}, {}, aside), 0.5 * kHighest_mps);
  EXPECT_GT(speed_mps({{0.9, -1.0}}), 0.5 * kHighest_mps);
}

}  // namespace
}  // namespace bslnav
