#include <chrono>
#include <csignal>
#include <thread>

#include "AppTest.h"

namespace bslnav::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class PaperApp : public AppTest {
 protected:
  Arguments words(const std::string& runs, const std::string& jobs, const std::string& name) const {
    return {"paper",  "--cases", "s1",     "--methods", "1",     "2",
            "--runs", runs,      "--jobs", jobs,        "--out", path(name)};
  }
  AppResult reproduce(const std::string& jobs, const std::string& name) const {
    Arguments arguments = words("2", jobs, name);
    arguments.insert(arguments.end(),
                     {"--set", "pictures.snapshots_s=6"});  // drawing takes longest
    return run(arguments, "bslnav-experiment");
  }
};

TEST_F(PaperApp, LeavesTablesFiguresAndConfigurations) {
  const AppResult result = reproduce("2", "out");
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.err, "");                  // no progress in a pipe
  EXPECT_EQ(rowsOf(out("results.csv")), 4U);  // 2 methods, 2 seeds
  EXPECT_THAT(readFile(out("results.csv")), StartsWith("case,method,seed,outcome,contact,"));
  const auto json = nlohmann::json::parse(readFile(out("results.json")));
  EXPECT_EQ(json["results"].size(), 2U);
  EXPECT_EQ(json["results"][1]["paper"]["time_to_goal_s"], 25.3);
  EXPECT_THAT(readFile(out("tables.md")), HasSubstr("| S1 | 1: ROS default |"));
  EXPECT_THAT(result.out, HasSubstr(readFile(out("tables.md"))));
  for (const char* file :
       {"figure-s1.png", "speed-s1.png", "config-s1-method1.ini", "config-s1-method2.ini"})
    EXPECT_GT(readFile(out(file)).size(), 10000U) << file;
}

TEST_F(PaperApp, TheNumberOfJobsDoesNotMatter) {
  ASSERT_EQ(reproduce("1", "alone").exitCode, 0);
  ASSERT_EQ(reproduce("2", "together").exitCode, 0);
  for (const char* file :
       {"results.csv", "results.json", "tables.md", "figure-s1.png", "speed-s1.png"})
    EXPECT_TRUE(readFile(out(file, "alone")) == readFile(out(file, "together"))) << file;
}

TEST_F(PaperApp, AnInterruptKeepsTheRunsThatAreDone) {
  using namespace std::chrono_literals;
  AppProcess process("bslnav-experiment", words("100000", "2", "out"), path(""));
  // The configurations are there before the first run, which takes less than a second.
  while (process.isRunning() && !exists(out("config-s1-method2.ini")))
    std::this_thread::sleep_for(5ms);
  std::this_thread::sleep_for(1s);
  ASSERT_TRUE(process.isRunning());
  process.send(SIGINT);
  EXPECT_EQ(process.wait().exitCode, 1);
  EXPECT_THAT(readFile(out("results.csv")), StartsWith("case,method,seed,"));
  EXPECT_LT(rowsOf(out("results.csv")), 100000U);
  EXPECT_THAT(readFile(out("tables.md")), HasSubstr("| S1 | 1: ROS default |"));
  EXPECT_TRUE(exists(out("figure-s1.png")));
}

TEST_F(PaperApp, RefusesWhatItCannotRun) {
  const auto refused = [this](Arguments arguments) {
    arguments.insert(arguments.begin(), "paper");
    arguments.insert(arguments.end(), {"--out", path("out")});
    const AppResult result = run(arguments, "bslnav-experiment");
    EXPECT_EQ(result.exitCode, 2);
    return result.err;
  };
  EXPECT_THAT(refused({"--cases", "s17"}), HasSubstr("--cases s17: no such case"));
  EXPECT_THAT(refused({"--cases", "../scenarios/s1"}), HasSubstr("no such case"));
  EXPECT_THAT(refused({"--cases", "s1", "s1"}), HasSubstr("each case once"));
  EXPECT_THAT(refused({"--cases", "s1", "--methods", "2", "2"}), HasSubstr("each method once"));
  EXPECT_THAT(refused({"--cases", "s1", "--set", "dwa.horizn_s=3"}), HasSubstr("horizon_s"));
  EXPECT_FALSE(exists(path("out")));
}

}  // namespace
}  // namespace bslnav::test
