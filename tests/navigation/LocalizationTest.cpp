#include <bslnav/navigation/Localization.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPose2D;

SensorFrame frameAt(const TPose2D& odometry, bool afterGap = false) {
  SensorFrame frame;
  frame.odometry = odometry;
  frame.afterGap = afterGap;
  return frame;
}

void expectNear(const TPose2D& a, const TPose2D& b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
  EXPECT_NEAR(std::remainder(a.phi - b.phi, 2 * M_PI), 0.0, 1e-9);
}

TEST(OdometryLocalization, StartsAtTheInitialPoseWhateverTheOdometrySays) {
  OdometryLocalization localization({1, 2, 0.5});
  expectNear(localization.update(frameAt({7, 7, 2})), {1, 2, 0.5});
}

TEST(OdometryLocalization, ComposesIncrementsInTheRobotFrame) {
  // The odometry faces x and moves 1 m along x; the robot faces y in the map, so it moves along y.
  OdometryLocalization localization({1, 2, M_PI / 2});
  localization.update(frameAt({5, 0, 0}));
  expectNear(localization.update(frameAt({6, 0, 0})), {1, 3, M_PI / 2});
}

TEST(OdometryLocalization, IntegratesNothingOverAGap) {
  OdometryLocalization localization({});
  localization.update(frameAt({0, 0, 0}));
  localization.update(frameAt({1, 0, 0}));
  expectNear(localization.update(frameAt({9, 9, 1}, true)), {1, 0, 0});
  expectNear(localization.update(frameAt(TPose2D(9, 9, 1) + TPose2D(0.5, 0, 0))), {1.5, 0, 0});
}

/** Where the odometry frame lies must not matter. */
RC_GTEST_PROP(OdometryLocalization, DoesNotDependOnTheOdometryFrame, ()) {
  const auto anyPose = [] {
    return TPose2D(*rc::gen::inRange(-50, 50) * 0.1, *rc::gen::inRange(-50, 50) * 0.1,
                   *rc::gen::inRange(-31, 31) * 0.1);
  };
  const TPose2D initial = anyPose(), shift = anyPose();
  OdometryLocalization one(initial), other(initial);
  for (int i = 0; i < 5; ++i) {
    const TPose2D odometry = anyPose();
    expectNear(one.update(frameAt(odometry)), other.update(frameAt(shift + odometry)));
  }
}

}  // namespace
}  // namespace bslnav
