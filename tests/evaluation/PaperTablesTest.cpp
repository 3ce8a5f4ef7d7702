#include <bslnav/evaluation/PaperNumbers.h>
#include <bslnav/evaluation/PaperTables.h>

#include "ExperimentRig.h"

namespace bslnav {
namespace {

using test::contactRun;
using test::goalRun;
using testing::ElementsAre;

std::vector<std::string> rowsOf(const std::string& table) {
  std::istringstream stream(table);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  lines.erase(lines.begin(), lines.begin() + 2);  // header and rule
  return lines;
}

PaperResult result(int method, const std::optional<RunSummary>& nominal,
                   std::vector<RunSummary> seeds = {}) {
  return {"s1", "S1", method, "name" + std::to_string(method), nominal, std::move(seeds)};
}

TEST(PaperNumbers, GiveThePapersImprovementOfMethod4OverMethod2) {
  const auto improvement = [](const std::string& caseName) {
    return fasterBy_percent(*paperNumbers(caseName, 4)->time_s, *paperNumbers(caseName, 2)->time_s);
  };
  EXPECT_NEAR(improvement("s1"), 27.7, 0.05);  // "improved by 27.7 %"
  EXPECT_NEAR(improvement("s2"), 13.9, 0.05);  // "improved by 13.9 %"
}

TEST(PaperNumbers, SayOnlyThatMethod4ReachedTheGoalOnTheRealRobot) {
  EXPECT_EQ(paperNumbers("s2", 1)->outcome, Outcome::Contact);
  EXPECT_EQ(paperNumbers("e1", 4)->outcome, Outcome::Goal);
  EXPECT_FALSE(paperNumbers("e2", 4)->time_s);
  EXPECT_FALSE(paperNumbers("e1", 2));
  EXPECT_FALSE(paperNumbers("office", 4));
}

TEST(NominalTable, StandsBesideThePaperAndComparesMethod4WithMethod2) {
  // (20.0 - 15.0) / 20.0 = 25 %
  EXPECT_THAT(rowsOf(nominalTable({result(1, contactRun(1)), result(2, goalRun(2, 20.0, 0.1)),
                                   result(4, goalRun(4, 15.0, 0.2))})),
              ElementsAre("| S1 | 1: name1 | contact | - | contact | - |",
                          "| S1 | 2: name2 | goal | 20.0 | goal | 25.3 |",
                          "| S1 | 4: name4 | goal | 15.0 | goal | 18.3 |",
                          "| S1 | 4 faster than 2 by |  | 25.0 % |  | 27.7 % |"));
}

TEST(NominalTable, HasDashesForWhatThereIsNot) {
  PaperResult other = result(2, std::nullopt);  // stopped before, and not in the paper
  other.caseName = "office";
  other.title = "office";
  EXPECT_THAT(
      rowsOf(nominalTable({result(2, goalRun(2, 20.0, 0.1)), result(4, contactRun(4)), other})),
      ElementsAre("| S1 | 2: name2 | goal | 20.0 | goal | 25.3 |",
                  "| S1 | 4: name4 | contact | - | goal | 18.3 |",
                  "| S1 | 4 faster than 2 by |  | - |  | 27.7 % |",
                  "| office | 2: name2 | - | - | - | - |"));
}

TEST(SeedsTable, AddsUpTheSeedsOfEachMethod) {
  // 3 of 4 at the goal; mean 12, half width 1.96 * sqrt(4 / 3) = 2.26; clearances 0, 0.2, 0.4, 0.6
  const PaperResult second =
      result(2, std::nullopt,
             {goalRun(2, 10.0, 0.6), goalRun(2, 12.0, 0.2), goalRun(2, 14.0, 0.4), contactRun(2)});
  EXPECT_THAT(rowsOf(seedsTable({result(1, std::nullopt), second})),
              ElementsAre("| S1 | 1: name1 | 0 | - | 0 | 0 | 0 | - | - | - |",
                          "| S1 | 2: name2 | 4 | 75.0 | 1 | 1 | 0 | 12.0 +/- 2.3 | 0.00 | 0.30 |"));
}

TEST(PaperTables, NameTheSeeds) {
  const std::string tables = paperTables({result(1, contactRun(1))}, {11, 20});
  EXPECT_THAT(tables, testing::HasSubstr("as written, seed 11,"));
  EXPECT_THAT(tables, testing::HasSubstr("Seeds 11 to 30:"));
  EXPECT_THAT(tables, testing::HasSubstr(nominalTable({result(1, contactRun(1))})));
}

}  // namespace
}  // namespace bslnav
