#include <bslnav/hardware/DriveClock.h>
#include <gtest/gtest.h>

namespace bslnav {
namespace {

struct Clocks {
  double steady_s = 50.0, mrpts_s = 1e9;
  DriveClock clock{[this] { return steady_s; }, [this] { return mrpts_s; }};
  void pass(double time_s) {
    steady_s += time_s;
    mrpts_s += time_s;
  }
};

TEST(DriveClock, BeginsAtZero) {
  Clocks clocks;
  EXPECT_EQ(clocks.clock.time_s(), 0.0);
  EXPECT_EQ(clocks.clock.startTime_s(), 1e9);
  clocks.pass(2.0);
  EXPECT_FALSE(clocks.clock.followJumps());
  EXPECT_EQ(clocks.clock.time_s(), 2.0);
  EXPECT_EQ(clocks.clock.startTime_s(), 1e9);
}

/** Somebody sets the machine's clock: stamps made from then on belong to the same drive time. */
TEST(DriveClock, FollowsAJumpOfTheMachinesClock) {
  Clocks clocks;
  clocks.pass(2.0);
  clocks.mrpts_s -= 3600.0;
  EXPECT_TRUE(clocks.clock.followJumps());
  EXPECT_FALSE(clocks.clock.followJumps());
  EXPECT_EQ(clocks.clock.time_s(), 2.0);
  EXPECT_NEAR(clocks.mrpts_s - clocks.clock.startTime_s(), 2.0, 1e-4);
}

TEST(DriveClock, ASlowDriftIsNoJump) {
  Clocks clocks;
  for (int k = 0; k < 100; ++k) {
    clocks.pass(0.1);
    clocks.mrpts_s += 0.001;
    EXPECT_FALSE(clocks.clock.followJumps());
  }
  EXPECT_NEAR(clocks.clock.startTime_s(), 1e9 + 0.1, 1e-4);
}

}  // namespace
}  // namespace bslnav
