#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "AppTest.h"

namespace bslnav::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class CampaignApp : public AppTest {
 protected:
  /** Method 1 with its laser, from the campaign's seed 1. */
  AppResult campaign(Arguments arguments, const std::string& name = "out") const {
    arguments.insert(arguments.begin(), {"campaign", "--method", "1", "--sensors", "laser"});
    arguments.insert(arguments.end(), {"--out", path(name)});
    return run(arguments, "bslnav-experiment");
  }
};

TEST_F(CampaignApp, LeavesRowsTablesAndFigures) {
  const AppResult result = campaign({"--encounters", "2"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(rowsOf(out("results.csv")), 2U);
  EXPECT_THAT(readFile(out("results.csv")),
              StartsWith("encounter,family,seed,method,engine,sensors,outcome,contact,at_fault,"
                         "impact_speed_mps,min_clearance_m,time_to_goal_s,time_empty_s"));
  EXPECT_THAT(result.out, HasSubstr(readFile(out("tables.md"))));
  EXPECT_EQ(nlohmann::json::parse(readFile(out("results.json")))[0]["encounters"], 2);
  for (const char* figure : {"figure-faults.png", "figure-times.png", "figure-clearances.png"})
    EXPECT_TRUE(exists(out(figure))) << figure;
}

TEST_F(CampaignApp, GoesOnWhereItWasStopped) {
  ASSERT_EQ(campaign({"--encounters", "3"}, "whole").exitCode, 0);
  ASSERT_EQ(campaign({"--encounters", "2"}).exitCode, 0);
  std::ofstream(out("results.csv"), std::ios::app) << "2,corner";  // killed while writing
  ASSERT_EQ(campaign({"--encounters", "3"}).exitCode, 0);
  EXPECT_EQ(readFile(out("results.csv")), readFile(out("results.csv", "whole")));
}

TEST_F(CampaignApp, RefusesToMixCampaigns) {
  ASSERT_EQ(campaign({"--encounters", "1"}).exitCode, 0);
  const AppResult other = campaign({"--encounters", "1", "--set", "limits.max_speed_mps=0.4"});
  EXPECT_NE(other.exitCode, 0);
  EXPECT_THAT(other.err, HasSubstr("another campaign"));
}

TEST_F(CampaignApp, AReplayIsTheSameRunAndAScenarioOfItsOwn) {
  ASSERT_EQ(campaign({"--encounters", "2"}).exitCode, 0);
  ASSERT_EQ(campaign({"--replay", "1"}, "replay").exitCode, 0);
  const auto replayed = summary("replay");
  char row[64];
  std::snprintf(row, sizeof row, ",%.4f,", replayed["path_length_m"].get<double>());
  EXPECT_THAT(readFile(out("results.csv")), HasSubstr(row));
  EXPECT_TRUE(exists(out("trajectory.png", "replay")));
  const AppResult again = drive(out("config.ini", "replay"),
                                {"--seed", std::to_string(replayed["seed"].get<long>())}, "again");
  ASSERT_EQ(again.exitCode, 0) << again.err;
  EXPECT_EQ(withoutTimings(summary("again")), withoutTimings(replayed));
  EXPECT_EQ(readFile(out("cycles.csv", "again")).size(),
            readFile(out("cycles.csv", "replay")).size());
}

TEST_F(CampaignApp, LeavesOutWhatARobotCannotDoAndSaysSo) {
  const AppResult result = run({"campaign", "--method", "1", "--method", "3", "--sensors", "laser",
                                "--encounters", "1", "--empty-every", "0", "--out", path("out")},
                               "bslnav-experiment");
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(rowsOf(out("results.csv")), 1U);
  EXPECT_THAT(result.out, HasSubstr("left out: Method 3 with laser"));
}

TEST_F(CampaignApp, RefusesWhatItCannotRun) {
  EXPECT_EQ(campaign({"--engine", "magic"}).exitCode, 2);
  EXPECT_EQ(campaign({"--encounters", "0"}).exitCode, 2);
  EXPECT_EQ(campaign({"--set", "campaign.slowest_mps=2"}).exitCode, 2);
  const AppResult two = campaign({"--method", "2", "--replay", "1"});
  EXPECT_EQ(two.exitCode, 2);
  EXPECT_THAT(two.err, HasSubstr("--replay"));
  const AppResult none =
      run({"campaign", "--method", "3", "--sensors", "laser", "--out", path("out")},
          "bslnav-experiment");
  EXPECT_EQ(none.exitCode, 2);
  EXPECT_THAT(none.err, HasSubstr("depth camera"));
}

TEST_F(CampaignApp, TwoProcessesUnderMpirunGiveTheSameBytesAsOne) {
  ASSERT_EQ(campaign({"--encounters", "3"}, "alone").exitCode, 0);
  setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);  // in a container there may be nobody else
  setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  const AppResult result = run(
      {"-n", "2", "--oversubscribe", BSLNAV_PROGRAMS "/bslnav-experiment", "campaign", "--method",
       "1", "--sensors", "laser", "--encounters", "3", "--jobs", "1", "--out", path("out")},
      BSLNAV_MPIRUN);
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_TRUE(exists(out("results.1-of-2.csv")));
  for (const char* file : {"results.csv", "results.json", "tables.md"})
    EXPECT_EQ(readFile(out(file)), readFile(out(file, "alone"))) << file;
}

}  // namespace
}  // namespace bslnav::test
