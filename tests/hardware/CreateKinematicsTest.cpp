#include <bslnav/hardware/CreateKinematics.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace bslnav::test {
namespace {

/** A count is 1 mm, and what turns one wheel by 1 m turns the robot by 90 degrees. */
CreateParameters roundNumbers() {
  CreateParameters parameters;
  parameters.wheelDiameter_m = 1.0 / M_PI;
  parameters.countsPerRevolution = 1000.0;
  parameters.wheelBase_m = 2.0 / M_PI;
  return parameters;
}

TEST(CreateKinematics, WheelsOfACommand) {
  // 0.2 m/s -+ 0.5 rad/s * 0.235 m / 2 = 0.2 m/s -+ 0.05875 m/s
  const CreateWheels wheels = wheelsOf({0.2, 0.0, 0.5}, {});
  EXPECT_NEAR(wheels.left_mps, 0.14125, 1e-12);
  EXPECT_NEAR(wheels.right_mps, 0.25875, 1e-12);
}

RC_GTEST_PROP(CreateKinematicsLaw, WheelsKeepTheirTopSpeedAndTheCurvature, ()) {
  const double vx = *rc::gen::inRange(-2000, 2001) / 1e3;
  const double omega = *rc::gen::inRange(-9000, 9001) / 1e3;
  const CreateParameters parameters;
  const CreateWheels wheels = wheelsOf({vx, 0.0, omega}, parameters);
  RC_ASSERT(std::abs(wheels.left_mps) <= parameters.maxWheelSpeed_mps + 1e-12);
  RC_ASSERT(std::abs(wheels.right_mps) <= parameters.maxWheelSpeed_mps + 1e-12);
  const double drivenV = 0.5 * (wheels.left_mps + wheels.right_mps);
  const double drivenW = (wheels.right_mps - wheels.left_mps) / parameters.wheelBase_m;
  RC_ASSERT(std::abs(drivenV * omega - drivenW * vx) < 1e-9);
  RC_ASSERT(drivenV * vx >= 0.0 && drivenW * omega >= 0.0);
}

TEST(CreateOdometry, TenTurnsOfTheRealWheelsAreTenCircumferences) {
  CreateOdometry odometry(CreateParameters{});
  odometry.add(7, 9, 0.0);
  odometry.add(7 + 5088, 9 + 5088, 1.0);
  EXPECT_NEAR(odometry.pose().x, 10.0 * M_PI * 0.072, 1e-9);
  EXPECT_EQ(odometry.pose().y, 0.0);
}

TEST(CreateOdometry, AroundAStandingWheelIsAQuarterOfACircle) {
  // The left wheel stands at (0, b/2), the robot ends as far to the right of it as it was below.
  CreateOdometry odometry(roundNumbers());
  odometry.add(0, 0, 0.0);
  odometry.add(0, 1000, 0.015);
  EXPECT_NEAR(odometry.pose().x, 1.0 / M_PI, 1e-9);
  EXPECT_NEAR(odometry.pose().y, 1.0 / M_PI, 1e-9);
  EXPECT_NEAR(odometry.pose().phi, M_PI / 2.0, 1e-9);
}

TEST(CreateOdometry, CountsRollOver) {
  CreateOdometry odometry(roundNumbers());
  odometry.add(65530, 65530, 0.0);
  odometry.add(4, 4, 0.015);  // 10 counts on
  EXPECT_NEAR(odometry.pose().x, 0.010, 1e-12);
  odometry.add(65526, 65526, 0.030);  // 14 back
  EXPECT_NEAR(odometry.pose().x, -0.004, 1e-12);
}

TEST(CreateOdometry, TwistIsTheMeanOfTheLast60Milliseconds) {
  CreateOdometry odometry(roundNumbers());
  odometry.add(0, 0, 0.0);
  EXPECT_EQ(odometry.twist().vx, 0.0);
  int left = 0, right = 0, frame = 0;
  const auto goOn = [&](int leftStep, int rightStep, int frames) {
    for (int i = 0; i < frames; ++i)
      odometry.add(static_cast<std::uint16_t>(left += leftStep),
                   static_cast<std::uint16_t>(right += rightStep), 0.015 * ++frame);
  };
  goOn(0, 6, 10);  // the right wheel 6 mm in 15 ms: 0.4 m/s, and 0.4 m/s / (2 / pi m)
  EXPECT_NEAR(odometry.twist().vx, 0.2, 1e-9);
  EXPECT_NEAR(odometry.twist().omega, 0.2 * M_PI, 1e-9);
  goOn(0, 0, 2);  // half of the window
  EXPECT_NEAR(odometry.twist().vx, 0.1, 1e-9);
  goOn(0, 0, 2);
  EXPECT_EQ(odometry.twist().vx, 0.0);
  EXPECT_EQ(odometry.twist().omega, 0.0);
}

TEST(CreateOdometry, TwistIsFiniteWhenFramesComeAllAtOnce) {
  CreateOdometry odometry(roundNumbers());
  for (const int counts : {0, 10, 20}) {
    const auto both = static_cast<std::uint16_t>(counts);
    odometry.add(both, both, 5.0);
  }
  EXPECT_EQ(odometry.twist().vx, 0.0);
  odometry.add(40, 40, 5.2);  // 40 mm since 0.2 s
  EXPECT_NEAR(odometry.twist().vx, 0.1, 0.11);
}

}  // namespace
}  // namespace bslnav::test
