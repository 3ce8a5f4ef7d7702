#include <bslnav/evaluation/PaperResults.h>

#include <nlohmann/json.hpp>

#include "ExperimentRig.h"

namespace bslnav {
namespace {

using test::contactRun;
using test::goalRun;
using test::hallCase;

RunSummary seeded(RunSummary run, std::uint64_t seed) {
  run.seed = seed;
  return run;
}

std::vector<PaperResult> twoMethods() {
  return {{"s1", "S1", 1, "ROS default", contactRun(1), {seeded(contactRun(1), 4)}},
          {"s1",
           "S1",
           2,
           "laser",
           std::nullopt,
           {seeded(goalRun(2, 20.0, 0.25), 4), seeded(goalRun(2, 22.0, 0.75), 5)}}};
}

TEST(PaperResults, PutRunsToTheirCasesAndMethods) {
  const std::vector<ExperimentCase> cases{hallCase("near", 1), hallCase("near", 2),
                                          hallCase("far", 1)};
  const std::vector<NominalRun> nominal{{cases[1], goalRun(2, 9.0, 1.0), {}}};
  std::vector<ExperimentResult> seeds(3);
  const char* const names[] = {"far", "near", "far"};
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    seeds[i].run.caseName = names[i];
    seeds[i].run.method = 1;
    seeds[i].summary = goalRun(1, 1.0 + static_cast<double>(i), 1.0);
  }
  const auto results = paperResults(cases, nominal, seeds);
  ASSERT_EQ(results.size(), 3u);
  EXPECT_EQ(results[1].method, 2);
  EXPECT_FALSE(results[0].nominal);
  EXPECT_EQ(results[1].nominal.value().timeToGoal_s, 9.0);
  ASSERT_EQ(results[2].seeds.size(), 2u);
  EXPECT_EQ(results[2].seeds[1].timeToGoal_s, 3.0);
  EXPECT_EQ(results[0].seeds.size(), 1u);
}

TEST(PaperResults, CsvHasARowForEverySeedWithTheKeysFirst) {
  EXPECT_EQ(resultsCsv(twoMethods()),
            "case,method,seed,outcome,contact,at_fault,impact_speed_mps,min_clearance_m,"
            "time_to_goal_s,path_length_m,time_stopped_s,blind_spots_mean\n"
            "s1,1,4,contact,1,1,0.5000,-0.0100,,0.0000,0.00,0.000\n"
            "s1,2,4,goal,0,0,,0.2500,20.0000,0.0000,0.00,0.000\n"
            "s1,2,5,goal,0,0,,0.7500,22.0000,0.0000,0.00,0.000\n");
}

TEST(PaperResults, JsonHasTheNominalRunThePaperAndWhatTheSeedsAddUpTo) {
  const auto entries = nlohmann::json::parse(resultsJson(twoMethods()))["results"];
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0]["nominal"]["outcome"], "contact");
  EXPECT_EQ(entries[0]["paper"]["outcome"], "contact");
  EXPECT_TRUE(entries[0]["seeds"]["time_to_goal_mean_s"].is_null());
  EXPECT_TRUE(entries[1]["nominal"].is_null());
  EXPECT_EQ(entries[1]["paper"]["time_to_goal_s"], 25.3);
  EXPECT_EQ(entries[1]["seeds"]["goals"], 2);
  EXPECT_EQ(entries[1]["seeds"]["time_to_goal_mean_s"], 21.0);
  EXPECT_EQ(entries[1]["seeds"]["min_clearance_min_m"], 0.25);
  EXPECT_EQ(entries[1]["seeds"]["min_clearance_median_m"], 0.5);
  EXPECT_EQ(entries[1]["runs"][1]["seed"], 5);
}

TEST(PaperResults, NothingDependsOnWallClockTimes) {
  auto slow = twoMethods();
  slow[1].seeds[0].cycle_ms.p50 = 123.0;
  EXPECT_EQ(resultsCsv(slow), resultsCsv(twoMethods()));
  EXPECT_EQ(resultsJson(slow), resultsJson(twoMethods()));
}

}  // namespace
}  // namespace bslnav
