#include <bslnav/campaign/Yardstick.h>
#include <gmock/gmock.h>

namespace bslnav {
namespace {

constexpr double kAcceleration = 0.5, kFastest = 0.56;
const StoppingAbility kRobot{0.25, 0.5, 0.2};

double passTime(const CornerPass& pass, double personSpeed_mps) {
  return fastestPass_s(pass, kRobot, kAcceleration, kFastest, personSpeed_mps).value_or(1e9);
}

TEST(Yardstick, WithNobodyToFearIsATrapezoidOfSpeed) {
  // From standing to standing: s / v + v / a; the grid of speeds and places costs a little.
  const double exact = 7.5 / kFastest + kFastest / kAcceleration;
  EXPECT_GE(passTime({}, 0.0), exact - 1e-6);
  EXPECT_LE(passTime({}, 0.0), 1.02 * exact);
}

TEST(Yardstick, FasterPeopleCostTime) {
  double last = passTime({}, 0.0);
  for (const double person : {0.6, 1.1111, 1.6}) {
    const double time = passTime({}, person);
    EXPECT_GE(time, last);
    last = time;
  }
  EXPECT_GT(last, 1.02 * passTime({}, 0.0));
}

TEST(Yardstick, RoomToSwingWideSavesTime) {
  CornerPass narrow, wide;
  narrow.right_m = wide.right_m = 0.6;
  narrow.left_m = 0.4;
  wide.left_m = 2.0;
  EXPECT_GT(passTime(narrow, 1.6), passTime(wide, 1.6) + 0.2);
}

TEST(Yardstick, NobodyRightBehindTheCornerSavesTime) {
  CornerPass points, discs;
  points.left_m = discs.left_m = 0.6;
  points.personRadius_m = 0.0;
  EXPECT_LT(passTime(discs, 1.1111), passTime(points, 1.1111) - 0.1);
}

TEST(Yardstick, StraightPastTheCornerItKeepsToTheBoundOfTheFormula) {
  // A corridor as narrow as the robot: v* = a ((D - r) / v_h - tau) straight past the corner.
  CornerPass pass;
  pass.right_m = 0.7;
  pass.left_m = 0.26;
  pass.personRadius_m = 0.0;
  const double bound = 0.5 * ((0.7 - 0.25) / 1.1111 - 0.2);
  ASSERT_LT(bound, 0.15);
  // Some of the way before the corner has to be driven at about the bound.
  EXPECT_GT(passTime(pass, 1.1111), passTime(pass, 0.0) + 0.3 / bound - 0.3 / kFastest);
}

TEST(Yardstick, ThereIsNoneWhereTheRobotWouldHaveToTouchTheCorner) {
  CornerPass pass;
  pass.right_m = 0.4;
  pass.left_m = 0.26;
  pass.personRadius_m = 0.0;
  EXPECT_FALSE(fastestPass_s(pass, kRobot, kAcceleration, kFastest, 1.1111));
}

}  // namespace
}  // namespace bslnav
