#include <bslnav/hardware/PaceKeeper.h>
#include <gtest/gtest.h>

#include <thread>

namespace bslnav {
namespace {

void work(double time_s) { std::this_thread::sleep_for(std::chrono::duration<double>(time_s)); }

TEST(PaceKeeper, WaitsForItsPeriod) {
  const auto begin = std::chrono::steady_clock::now();
  PaceKeeper pace(0.05);
  for (int k = 0; k < 5; ++k) {
    pace.wait();
    pace.sent();
  }
  const double passed_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_GE(passed_s, 4 * 0.05);  // the first cycle begins at once
  EXPECT_EQ(pace.cycles(), 5);
}

/** A cycle of four periods: the next one begins three periods late, and the robot drives 0.7 times
 * as fast; after that it is on time, and comes back to its speed by 0.02 a cycle. */
TEST(PaceKeeper, SlowsDownAfterAMissAndComesBack) {
  PaceKeeper pace(0.1);
  pace.wait();
  work(0.4);
  pace.sent();
  pace.wait();
  EXPECT_EQ(pace.misses(), 1);
  EXPECT_GT(pace.computing_s(), 0.3);
  const auto slow = pace.paced({1.0, 0.0, 0.5});
  EXPECT_NEAR(slow.vx, 0.7, 1e-9);
  EXPECT_NEAR(slow.omega, 0.35, 1e-9);
  pace.sent();
  pace.wait();
  EXPECT_GE(pace.share(), 0.7 * 0.7);  // a loaded machine may be late again
}

TEST(PaceKeeper, NeverStopsTheRobotForGood) {
  PaceKeeper pace(0.005);
  for (int k = 0; k < 10; ++k) {
    pace.wait();
    work(0.03);
  }
  EXPECT_GE(pace.share(), 0.3);
  EXPECT_LT(pace.share(), 0.5);
}

}  // namespace
}  // namespace bslnav
