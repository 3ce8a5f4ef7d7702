#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ostream>

#include "AppTest.h"

namespace bslnav::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

/** What stands in a configuration behind the room's, or on the command line, and what the one line
 * about it must say. */
struct BadInput {
  std::string name, ini;
  Arguments arguments;
  std::string where, expectation;
};

std::ostream& operator<<(std::ostream& out, const BadInput& bad) { return out << bad.name; }

class Refusal : public AppTest, public testing::WithParamInterface<BadInput> {};

TEST_P(Refusal, NamesThePlaceAndMovesNothing) {
  const BadInput& bad = GetParam();
  const AppResult result = drive(write("bad.ini", kRoom + bad.ini), bad.arguments);
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.out, IsEmpty());
  EXPECT_THAT(result.err, AllOf(HasSubstr(bad.where), HasSubstr(bad.expectation)));
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_FALSE(exists(out("summary.json")));
}

// The room is 6 m x 4 m from (-1, -2): (2, 9) is outside its map, and at (4.9, 0) a robot touches
// its wall.
const BadInput kBadInputs[] = {
    {"UnknownKey",
     "[dwa]\nhorizn_s = 4\n",
     {},
     "bad.ini [dwa] horizn_s",
     "did you mean 'horizon_s'"},
    {"UnknownSection", "[dwq]\nhorizon_s = 4\n", {}, "bad.ini [dwq]", "did you mean 'dwa'"},
    {"MalformedNumber", "[dwa]\nhorizon_s = 4 s\n", {}, "bad.ini [dwa] horizon_s", "'4 s'"},
    {"NotANumber", "[dwa]\nhorizon_s = nan\n", {}, "bad.ini [dwa] horizon_s", "'nan'"},
    {"OutOfRange", "[dwa]\nhorizon_s = -4\n", {}, "bad.ini [dwa] horizon_s", "expected"},
    {"UnknownWord", "[blind_spots]\nsource = scan\n", {}, "[blind_spots] source", "scan_jumps"},
    {"KeyTwice", "[dwa]\nhorizon_s = 4\nhorizon_s = 3\n", {}, "bad.ini", "horizon_s"},
    {"BrokenLine", "[dwa]\nhorizon_s 4\n", {}, "bad.ini", "expected key = value"},
    {"MissingFile", "", {"/no/such/file.ini"}, "/no/such/file.ini", "no such file"},
    {"Directory", "", {"/"}, "bslnav: /:", "is a directory"},
    {"UnknownMethod", "", {"--method", "9"}, "--method 9", "no such method"},
    {"OverrideWithoutDot", "", {"--set", "horizon_s=4"}, "--set horizon_s=4", "section.key=value"},
    {"OverrideOfUnknownKey", "", {"--set", "dwa.horizn_s=4"}, "--set [dwa] horizn_s", "horizon_s"},
    {"OverrideOutOfRange", "", {"--set", "dwa.horizon_s=-4"}, "--set [dwa] horizon_s", "expected"},
    {"NoGoal", "", {"--set", "scenario.goals="}, "[scenario] goals", "at least one"},
    {"WallWithoutPoints", "[wall:a]\nthickness_m = 0.1\n", {}, "[wall:a]", "points"},
    {"MissingMap", "", {"--set", "scenario.map=/no/such/map.yaml"}, "/no/such/map.yaml", "no such"},
    {"GoalOutsideTheMap",
     "",
     {"--set", "scenario.goals=2 9 0"},
     "[scenario] goals",
     "within the map"},
    {"StartInCollision",
     "",
     {"--set", "scenario.start=4.9 0 0"},
     "(4.9, 0)",
     "touches [wall:room]"},
};

INSTANTIATE_TEST_SUITE_P(BadInputs, Refusal, testing::ValuesIn(kBadInputs),
                         [](const auto& test) { return test.param.name; });

class RefusalOfDirectories : public AppTest {};

TEST_F(RefusalOfDirectories, ResultsThatCannotBeWrittenAreAFailedRun) {
  const std::string file = write("file", "not a directory");
  const AppResult result = run({write("room.ini", kRoom), "--out", file + "/results"});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.out, IsEmpty());
  EXPECT_THAT(result.err, HasSubstr(file + "/results"));
}

TEST_F(RefusalOfDirectories, AFullDiskIsAFailedRun) {
  ASSERT_EQ(drive(write("room.ini", kRoom)).exitCode, 0);
  // every write to /dev/full fails as on a full disk
  std::remove(out("cycles.csv").c_str());
  ASSERT_EQ(symlink("/dev/full", out("cycles.csv").c_str()), 0);
  const AppResult result = drive(path("room.ini"));
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr(out("cycles.csv")));
}

}  // namespace
}  // namespace bslnav::test
