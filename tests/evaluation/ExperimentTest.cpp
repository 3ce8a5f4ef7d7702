#include <bslnav/evaluation/Experiment.h>

#include <set>

#include "ExperimentRig.h"

namespace bslnav {
namespace {

using test::hallCase;
using test::resultOf;

const std::vector<ExperimentCase> kCases{hallCase("near", 1), hallCase("far", 2, 2.5)};

TEST(Experiment, RunsSeedBySeedTheCasesOfASeedTogether) {
  const auto results = runAll(kCases, {5, 3}, 2);
  ASSERT_EQ(results.size(), 6u);  // 3 seeds, 2 cases
  for (std::size_t i = 0; i < results.size(); ++i) {
    EXPECT_EQ(results[i].run.seed, 5 + i / 2);
    EXPECT_EQ(results[i].run.caseName, i % 2 == 0 ? "near" : "far");
    EXPECT_EQ(results[i].run.method, i % 2 == 0 ? 1 : 2);
  }
}

TEST(Experiment, EachRunIsTheVariedCaseWithItsSeed) {
  const auto results = runAll(kCases, {5, 2}, 2);
  ASSERT_EQ(results.size(), 4u);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const std::uint64_t seed = results[i].run.seed;
    EXPECT_EQ(resultOf(results[i].summary),
              resultOf(runSimulation(varied(kCases[i % 2].setup, seed), seed)));
    EXPECT_EQ(results[i].summary.seed, seed);
  }
}

TEST(Experiment, ResultsDoNotDependOnTheJobs) {
  const auto alone = runAll(kCases, {1, 4}, 1), together = runAll(kCases, {1, 4}, 2);
  ASSERT_EQ(alone.size(), together.size());
  for (std::size_t i = 0; i < alone.size(); ++i)
    EXPECT_EQ(resultOf(alone[i].summary), resultOf(together[i].summary)) << i;
}

TEST(Experiment, SeedsVary) {
  std::set<double> clearances;  // the walker's speed differs, so where the robot is nearest, too
  for (const auto& result : runAll({hallCase("hall", 1)}, {1, 4}, 2))
    clearances.insert(result.summary.minClearance_m.value());
  EXPECT_GT(clearances.size(), 1u);
}

TEST(Experiment, AfterAStopTheFirstRunsAreThere) {
  WorkWatch watch;
  int asked = 0;
  watch.goOn = [&asked] { return ++asked <= 3; };
  const auto results = runAll(kCases, {1, 50}, 2, watch);
  ASSERT_EQ(results.size(), 3u);
  EXPECT_EQ(results[2].run.seed, 2u);
  EXPECT_EQ(results[2].summary.outcome, Outcome::Goal);
}

TEST(Experiment, ASetupThatCannotBeRunIsRefused) {
  auto entry = hallCase("hall", 1);
  entry.setup.scenario.start = {9.0, 0.0, 0.0};  // in the wall
  EXPECT_THROW(runAll({entry}, {1, 3}, 2), Error);
}

}  // namespace
}  // namespace bslnav
