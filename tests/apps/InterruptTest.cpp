#include <chrono>
#include <csignal>
#include <thread>

#include "AppTest.h"

namespace bslnav::test {
namespace {

class Interrupt : public AppTest, public testing::WithParamInterface<int> {};

/** Between two places many times: minutes of simulated time, seconds of ours. */
std::string toAndFro() {
  std::string goals = "scenario.goals=3 1 0";
  for (int i = 0; i < 500; ++i) goals += i % 2 == 0 ? ", 0 -1 0" : ", 3 1 0";
  return goals;
}

TEST_P(Interrupt, EndsTheRunAndKeepsItsRecords) {
  using namespace std::chrono_literals;
  AppProcess process("bslnav",
                     {write("room.ini", kRoom), "--set", toAndFro(), "--set",
                      "scenario.time_limit_s=100000", "--out", path("out")},
                     path(""));
  // the header alone has less than 1000 bytes: then the run has begun
  while (process.isRunning() && readFile(out("cycles.csv")).size() < 1000)
    std::this_thread::sleep_for(5ms);
  ASSERT_TRUE(process.isRunning());
  process.send(GetParam());

  const AppResult result = process.wait();
  EXPECT_EQ(result.exitCode, 1) << result.err;
  EXPECT_EQ(summary()["outcome"], "error");
  EXPECT_EQ(summary()["reason"], "interrupted");
  EXPECT_EQ(rowsOf(out("cycles.csv")), summary()["cycles"].get<std::size_t>());
  EXPECT_TRUE(exists(out("config.ini")));
  EXPECT_TRUE(exists(out("trajectory.png")));
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, testing::Values(SIGINT, SIGTERM),
                         [](const auto& test) {
                           return test.param == SIGINT ? "CtrlC" : "Terminate";
                         });

}  // namespace
}  // namespace bslnav::test
