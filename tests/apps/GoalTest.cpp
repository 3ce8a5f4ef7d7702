#include <cmath>
#include <sstream>

#include "AppTest.h"

namespace bslnav::test {
namespace {

using testing::HasSubstr;

class Goal : public AppTest {
 protected:
  /** Column of the last row of cycles.csv. */
  double last(std::size_t column) const {
    const std::string text = readFile(out("cycles.csv"));
    std::istringstream row(text.substr(text.rfind('\n', text.size() - 2) + 1));
    std::string field;
    for (std::size_t i = 0; i <= column; ++i) std::getline(row, field, ',');
    return std::stod(field);
  }
};

TEST_F(Goal, InsideAnObstacleIsMovedToTheNearestFreePlace) {
  // The pillar's edge is 0.3 m from the goal; the free place nearest to it, a robot's radius
  // farther, is within the goal tolerance of 0.5 m.
  const std::string pillar = "[cylinder:pillar]\nx_m = 2.2\ny_m = 0\nradius_m = 0.1\n";
  const AppResult result = drive(write("pillar.ini", kRoom + pillar));
  EXPECT_EQ(result.exitCode, 0) << result.out;
  EXPECT_EQ(summary()["outcome"], "goal");
  EXPECT_LT(std::hypot(last(2) - 2.0, last(3)), 0.6);  // 0.5 m, and the motion's own 0.1 m
}

/** There and back twice: with a waypoint counted as passed 0.5 m before it, and the last 0.1 m not
 * driven, at least 1.5 + 1 + 1 + 1.4 m. */
TEST_F(Goal, RoundsAreDrivenOneAfterTheOther) {
  const AppResult result =
      drive(write("patrol.ini", kRoom), {"--set", "scenario.goals=2 0 0, 0 0 0", "--set",
                                         "scenario.rounds=2", "--set", "recording.memory_s=1"});
  EXPECT_EQ(result.exitCode, 0) << result.out;
  EXPECT_EQ(summary()["outcome"], "goal");
  EXPECT_GT(summary()["path_length_m"], 4.9);
  EXPECT_LT(std::hypot(last(2), last(3)), 0.2);
  EXPECT_GE(rowsOf(out("memory.csv")), summary()["duration_s"].get<std::size_t>());
  EXPECT_TRUE(exists(out("memory.png")));
}

TEST_F(Goal, BehindWallsEndsStuckWithAPicture) {
  // A closed cell of 2 m x 2 m around the goal: nothing outside it is within 0.5 m of the goal.
  const std::string cell = "[wall:cell]\npoints_m = 2 -1, 4 -1, 4 1, 2 1, 2 -1\n";
  const AppResult result =
      drive(write("cell.ini", kRoom + cell), {"--set", "scenario.goals=3 0 0"});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(summary()["outcome"], "stuck");
  EXPECT_THAT(summary()["reason"].get<std::string>(), HasSubstr("no path"));
  EXPECT_TRUE(exists(out("trajectory.png")));
  EXPECT_THAT(result.out, HasSubstr("no path"));
}

TEST_F(Goal, TooFarForTheTimeLimitEndsAsATimeout) {
  // 2 m at no more than 2.0 km/h take at least 3.6 s
  const AppResult result = drive(write("room.ini", kRoom), {"--set", "scenario.time_limit_s=3"});
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(summary()["outcome"], "timeout");
  EXPECT_TRUE(exists(out("trajectory.png")));
}

TEST_F(Goal, IsReachedThroughItsWaypoints) {
  const AppResult result =
      drive(write("room.ini", kRoom), {"--set", "scenario.goals=1.5 1 90, 3 -1 0"});
  EXPECT_EQ(result.exitCode, 0) << result.out;
  EXPECT_EQ(summary()["outcome"], "goal");
  EXPECT_LE(std::hypot(last(2) - 3.0, last(3) + 1.0), 0.1 + 0.05);
  // straight to the goal it is 3.16 m; the detour, less the tolerance at the waypoint, is longer
  EXPECT_GT(summary()["path_length_m"], 3.4);
}

}  // namespace
}  // namespace bslnav::test
