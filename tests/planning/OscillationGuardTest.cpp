#include <bslnav/planning/OscillationGuard.h>
#include <gtest/gtest.h>

namespace bslnav {
namespace {

constexpr OscillationParameters kParameters{0.1, 0.35, 0.05};

TEST(OscillationGuard, AllowsEverythingAtFirst) {
  const OscillationGuard guard(kParameters);
  EXPECT_TRUE(guard.allows(0.0, 1.0));
  EXPECT_TRUE(guard.allows(0.0, -1.0));
}

TEST(OscillationGuard, RefusesToTurnBackOnTheSpot) {
  OscillationGuard guard(kParameters);
  guard.commanded(0.0, 0.5, {0.0, 0.0, 0.0});
  EXPECT_FALSE(guard.allows(0.0, -0.1));
  EXPECT_FALSE(guard.allows(0.049, -0.1));
  EXPECT_TRUE(guard.allows(0.0, 0.1));
  EXPECT_TRUE(guard.allows(0.0, 0.0));    // standing
  EXPECT_TRUE(guard.allows(0.05, -0.1));  // a curve is not turning on the spot
}

TEST(OscillationGuard, RefusesTheOtherSideToo) {
  OscillationGuard guard(kParameters);
  guard.commanded(0.0, -0.5, {0.0, 0.0, 0.0});
  EXPECT_FALSE(guard.allows(0.0, 0.1));
}

TEST(OscillationGuard, AllowsTurningBackAfterMovingOn) {
  OscillationGuard guard(kParameters);
  guard.commanded(0.0, 0.5, {0.0, 0.0, 0.0});
  guard.commanded(0.3, 0.0, {0.09, 0.0, 0.0});
  EXPECT_FALSE(guard.allows(0.0, -0.1));
  guard.commanded(0.3, 0.0, {0.11, 0.0, 0.0});
  EXPECT_TRUE(guard.allows(0.0, -0.1));
}

TEST(OscillationGuard, AllowsTurningBackAfterTurningOnAcrossTheWrap) {
  OscillationGuard guard(kParameters);
  guard.commanded(0.0, 0.5, {0.0, 0.0, 3.1});
  guard.commanded(0.3, 0.0, {0.0, 0.0, -3.0});  // 0.18 rad on
  EXPECT_FALSE(guard.allows(0.0, -0.1));
  guard.commanded(0.3, 0.0, {0.0, 0.0, -2.8});  // 0.38 rad on
  EXPECT_TRUE(guard.allows(0.0, -0.1));
}

TEST(OscillationGuard, ForgetsWhenReset) {
  OscillationGuard guard(kParameters);
  guard.commanded(0.0, 0.5, {0.0, 0.0, 0.0});
  guard.reset();
  EXPECT_TRUE(guard.allows(0.0, -0.1));
}

}  // namespace
}  // namespace bslnav
