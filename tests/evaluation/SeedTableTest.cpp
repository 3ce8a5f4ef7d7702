#include <bslnav/evaluation/SeedTable.h>
#include <gmock/gmock.h>

#include <sstream>

namespace bslnav {
namespace {

RunSummary goal(int method, double time_s) {
  RunSummary run;
  run.method = method;
  run.methodName = "name" + std::to_string(method);
  run.outcome = Outcome::Goal;
  run.timeToGoal_s = time_s;
  return run;
}

RunSummary contact(int method, double impact_mps, bool atFault) {
  RunSummary run = goal(method, 0.0);
  run.outcome = Outcome::Contact;
  run.timeToGoal_s.reset();
  run.contact = true;
  run.atFault = atFault;
  run.impactSpeed_mps = impact_mps;
  run.minClearance_m = -0.01;
  return run;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(MeanInterval, IsTheNormalApproximationByHand) {
  // Mean 12; squares 4 + 0 + 4 = 8, variance 8/2 = 4, error √(4/3) = 1.1547, times 1.96.
  const MeanInterval interval = meanInterval({10.0, 12.0, 14.0});
  EXPECT_DOUBLE_EQ(interval.mean, 12.0);
  EXPECT_NEAR(interval.half, 1.96 * 1.154700538, 1e-8);
}

TEST(MeanInterval, HasNoWidthForFewerThanTwoValues) {
  EXPECT_EQ(meanInterval({}).mean, 0.0);
  EXPECT_EQ(meanInterval({5.0}).mean, 5.0);
  EXPECT_EQ(meanInterval({5.0}).half, 0.0);
}

TEST(SeedTable, MarkdownHasOneLineAMethodWithWhatItsRunsAddUpTo) {
  SeedTable table{"S1",
                  {goal(2, 10.0), contact(1, 0.5, true), goal(2, 12.0), contact(1, 0.01, false),
                   goal(2, 14.0), goal(1, 9.0)}};
  table.runs[0].minClearance_m = 0.75;
  table.runs[2].minClearance_m = 0.5;
  RunSummary stuck = goal(2, 0.0);
  stuck.outcome = Outcome::Stuck;
  stuck.timeToGoal_s.reset();
  table.runs.push_back(stuck);
  const auto lines = linesOf(table.markdown());
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(
      lines[0],
      "| S1 | runs | goal | contact | at fault | other | time to goal [s] | nearest person [m] |");
  EXPECT_EQ(lines[2], "| Method 1: name1 | 3 | 1 | 2 | 1 | 0 | 9.0 +/- 0.0 | 0.00 |");
  EXPECT_EQ(lines[3], "| Method 2: name2 | 4 | 3 | 0 | 0 | 1 | 12.0 +/- 2.3 | 0.50 |");
}

TEST(SeedTable, MarkdownHasDashesForWhatThereIsNot) {
  SeedTable table{"empty", {contact(1, 0.5, true)}};
  table.runs[0].minClearance_m.reset();  // a world without people
  EXPECT_EQ(linesOf(table.markdown())[2], "| Method 1: name1 | 1 | 0 | 1 | 1 | 0 | - | - |");
}

TEST(SeedTable, CsvHasTheColumnsOfTheDesignAndOneRowARun) {
  SeedTable table{"S1", {goal(2, 10.25), contact(1, 0.5, true)}};
  table.runs[0].seed = 7;
  table.runs[0].pathLength_m = 9.5;
  table.runs[0].timeStopped_s = 0.3;
  table.runs[0].blindSpotsMean = 4.125;
  const auto lines = linesOf(table.csv());
  ASSERT_EQ(lines.size(), 3u);
  for (const char* column : {"seed", "method", "outcome", "contact", "at_fault", "impact_speed_mps",
                             "min_clearance_m", "time_to_goal_s"})
    EXPECT_THAT("," + lines[0] + ",", testing::HasSubstr("," + std::string(column) + ","));
  EXPECT_EQ(lines[1], "S1,7,2,goal,0,0,,,10.2500,9.5000,0.30,4.125");
  EXPECT_EQ(lines[2], "S1,0,1,contact,1,1,0.5000,-0.0100,,0.0000,0.00,0.000");
}

TEST(SeedTable, CsvQuotesAScenarioNameWithCommasAndQuotes) {
  const SeedTable table{"hall, \"B\"", {goal(1, 1.0)}};
  EXPECT_EQ(linesOf(table.csv())[1].substr(0, 17), "\"hall, \"\"B\"\"\",0,1");
}

}  // namespace
}  // namespace bslnav
