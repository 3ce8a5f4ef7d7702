#include <bslnav/config/Error.h>
#include <bslnav/navigation/Localization.h>
#include <bslnav/navigation/RawlogReader.h>
#include <bslnav/navigation/RecordedPath.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "RawlogReaderLogs.h"

namespace bslnav {
namespace {

using mrpt::math::TPose2D;

/** A metre ahead in 1 s, then 2 m to the left in 4 s while turning from 3.0 rad over π to −3.0 rad.
 */
RecordedPath corner() {
  return RecordedPath({{10, {0, 0, 3.0}}, {11, {1, 0, 3.0}}, {15, {1, 2, -3.0}}});
}

TEST(RecordedPath, InterpolatesThePosition) {
  EXPECT_DOUBLE_EQ(corner().poseAt(10.25).x, 0.25);
  EXPECT_DOUBLE_EQ(corner().poseAt(13.0).y, 1.0);
}

TEST(RecordedPath, TurnsTheShorterWay) {
  // Halfway from 3.0 to −3.0 over π is π; the other way it would be 0.
  EXPECT_NEAR(std::abs(corner().poseAt(13.0).phi), M_PI, 1e-12);
}

TEST(RecordedPath, StaysAtItsEnds) {
  EXPECT_DOUBLE_EQ(corner().poseAt(0.0).x, 0.0);
  EXPECT_DOUBLE_EQ(corner().poseAt(100.0).y, 2.0);
}

TEST(RecordedPath, GivesTheGoalFromTheFuture) {
  EXPECT_DOUBLE_EQ(corner().goalAhead(10.0, 3.0).y, 1.0);
  EXPECT_DOUBLE_EQ(corner().goalAhead(14.0, 3.0).y, 2.0);  // no further than the end
}

TEST(RecordedPath, MeasuresItself) {
  EXPECT_DOUBLE_EQ(corner().length_m(), 3.0);
  EXPECT_DOUBLE_EQ(corner().duration_s(), 5.0);
}

TEST(RecordedPath, TakesTheLaterOfTwoPosesAtOneTime) {
  const RecordedPath path({{0, {0, 0, 0}}, {1, {1, 0, 0}}, {1, {5, 0, 0}}, {2, {6, 0, 0}}});
  EXPECT_DOUBLE_EQ(path.poseAt(1.0).x, 5.0);
}

TEST(RecordedPath, RefusesNothingAndTimesThatGoBack) {
  EXPECT_THROW(RecordedPath({}), Error);
  EXPECT_THROW(RecordedPath({{1, {}}, {0, {}}}), Error);
}

TEST(RecordedPath, IsRecordedFromALogThroughALocalization) {
  // The odometry says 0 → 1 m along x in 0.5 s; the robot starts at (2, 3) facing y in the map, and
  // so ends at (2, 4).
  RawlogReader log(testing_logs::LogWriter("recorded")
                       .sensoryFrame(0.0)
                       .action({1, 0, 0})
                       .sensoryFrame(0.5)
                       .close());
  OdometryLocalization localization({2, 3, M_PI / 2});
  const auto path = recordPath(log, localization);
  ASSERT_EQ(path.samples().size(), 2u);
  EXPECT_NEAR(path.duration_s(), 0.5, 1e-6);
  EXPECT_NEAR(path.poseAt(0.5).x, 2.0, 1e-12);
  EXPECT_NEAR(path.poseAt(0.5).y, 4.0, 1e-12);
}

std::vector<RecordedPath::Sample> anySamples() {
  std::vector<RecordedPath::Sample> samples;
  for (int i = 0; i < 8; ++i)
    samples.push_back({static_cast<double>(i),
                       {*rc::gen::inRange(-100, 100) * 0.1, *rc::gen::inRange(-100, 100) * 0.1,
                        *rc::gen::inRange(-31, 31) * 0.1}});
  return samples;
}

RC_GTEST_PROP(RecordedPath, GoesThroughItsSamples, ()) {
  const auto samples = anySamples();
  const RecordedPath path(samples);
  for (const auto& sample : samples) {
    const TPose2D difference = path.poseAt(sample.time_s) - sample.pose;
    RC_ASSERT(std::hypot(difference.x, difference.y) + std::abs(difference.phi) < 1e-9);
  }
}

RC_GTEST_PROP(RecordedPath, IsNoShorterThanTheWayBetweenAnyTwoOfItsPoses, ()) {
  const RecordedPath path(anySamples());
  const auto a = path.poseAt(*rc::gen::inRange(0, 70) * 0.1),
             b = path.poseAt(*rc::gen::inRange(0, 70) * 0.1);
  RC_ASSERT(std::hypot(b.x - a.x, b.y - a.y) <= path.length_m() + 1e-9);
}

}  // namespace
}  // namespace bslnav
