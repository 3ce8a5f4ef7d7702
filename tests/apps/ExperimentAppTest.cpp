#include "AppTest.h"

namespace bslnav::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ExperimentApp : public AppTest {
 protected:
  AppResult compare(Arguments arguments, const std::string& name = "out") const {
    arguments.insert(arguments.begin(), "seeds");
    arguments.insert(arguments.end(), {"--out", path(name)});
    return run(arguments, "bslnav-experiment");
  }
};

TEST_F(ExperimentApp, WritesARowForEverySeedAndMethod) {
  const AppResult result =
      compare({write("room.ini", kRoom), "--methods", "1", "2", "--runs", "3", "--seed", "5"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(rowsOf(out("results.csv")), 6U);  // 3 seeds, 2 methods
  const std::string csv = readFile(out("results.csv"));
  EXPECT_THAT(csv, StartsWith("scenario,seed,method,outcome,contact,at_fault,"));
  EXPECT_THAT(csv, HasSubstr("\nroom,5,1,goal,"));
  EXPECT_THAT(csv, HasSubstr("\nroom,7,2,goal,"));
  EXPECT_THAT(readFile(out("table.md")), HasSubstr("| Method 1"));
  EXPECT_THAT(result.out, HasSubstr(readFile(out("table.md"))));
}

TEST_F(ExperimentApp, TheSameCommandGivesTheSameBytes) {
  const std::string room = write("room.ini", kRoom);
  ASSERT_EQ(compare({room, "--runs", "2"}, "first").exitCode, 0);
  ASSERT_EQ(compare({room, "--runs", "2"}, "second").exitCode, 0);
  EXPECT_EQ(readFile(out("results.csv", "first")), readFile(out("results.csv", "second")));
}

TEST_F(ExperimentApp, TheNumberOfJobsDoesNotMatter) {
  const std::string room = write("room.ini", kRoom);
  ASSERT_EQ(compare({room, "--runs", "3", "--jobs", "1"}, "alone").exitCode, 0);
  ASSERT_EQ(compare({room, "--runs", "3", "--jobs", "2"}, "together").exitCode, 0);
  EXPECT_EQ(readFile(out("results.csv", "alone")), readFile(out("results.csv", "together")));
}

TEST_F(ExperimentApp, ComparesNavigators) {
  const AppResult result = run({"navigators", write("room.ini", kRoom), "--methods", "1", "--runs",
                                "1", "--out", path("out")},
                               "bslnav-experiment");
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(rowsOf(out("results.csv")), 6U);  // six navigators
  const std::string table = readFile(out("table.md"));
  for (const char* engine : {"| dwa |", "| ptg |", "| dwa, holonomic |", "| ptg, holonomic |",
                             "| mrpt ND |", "| mrpt FullEval |"})
    EXPECT_THAT(table, HasSubstr(engine));
  EXPECT_THAT(readFile(out("results.csv")), HasSubstr("\nroom,ptg,1,1,goal,"));
  EXPECT_THAT(readFile(out("results.csv")), HasSubstr("\nroom,\"ptg, holonomic\",1,1,goal,"));
}

TEST_F(ExperimentApp, RefusesWhatItCannotRun) {
  EXPECT_EQ(compare({}).exitCode, 2);
  EXPECT_EQ(run({"navigators", "--navigator", "ptg"}, "bslnav-experiment").exitCode, 2);
  EXPECT_EQ(compare({kS1, "--runs", "0"}).exitCode, 2);
  EXPECT_EQ(compare({kS1, "--method", "1"}).exitCode, 2);  // --methods is meant
  EXPECT_EQ(compare({kS1, "--methods", "1", "1"}).exitCode, 2);
  EXPECT_EQ(run({}, "bslnav-experiment").exitCode, 2);
  const AppResult method = compare({kS1, "--methods", "9"});
  EXPECT_EQ(method.exitCode, 2);
  EXPECT_THAT(method.err, HasSubstr("--method 9"));
  const AppResult file = compare({kS1, "--runs", "1", "--out", write("file", "") + "/results"});
  EXPECT_NE(file.exitCode, 0);
}

}  // namespace
}  // namespace bslnav::test
