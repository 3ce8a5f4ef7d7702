#include <mrpt/config/CConfigFileMemory.h>

#include "ConfigFixture.h"

namespace bslnav::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

TEST_F(ConfigTest, LoadsEveryKindOfValue) {
  load(
      "[robot]\nspeed_mps = -1.25\nangle_deg = 90\ncount = 7\nenabled = true\nname = my robot\n"
      "colour = red\noutline_m = 1 2, 3 4, 5 6\nspeeds_mps = 0, 3\nstart = 1 2 180\n"
      "goals = 0 0 0, 4 5 -90\n");
  EXPECT_EQ(robot.speed_mps, -1.25);
  EXPECT_DOUBLE_EQ(robot.angle_rad, M_PI / 2);
  EXPECT_EQ(robot.count, 7);
  EXPECT_TRUE(robot.enabled);
  EXPECT_EQ(robot.name, "my robot");
  EXPECT_EQ(robot.colour, Colour::Red);
  EXPECT_THAT(robot.outline, ElementsAre(mrpt::math::TPoint2D{1, 2}, mrpt::math::TPoint2D{3, 4},
                                         mrpt::math::TPoint2D{5, 6}));
  EXPECT_THAT(robot.speeds, ElementsAre(0.0, 3.0));
  EXPECT_DOUBLE_EQ(robot.start.phi, M_PI);
  ASSERT_EQ(robot.goals.size(), 2u);
  EXPECT_DOUBLE_EQ(robot.goals[1].phi, -M_PI / 2);
}

TEST_F(ConfigTest, KeepsDefaultsOfKeysThatAreNotGiven) {
  load("[robot]\ncount = 4\n");
  EXPECT_EQ(robot.speed_mps, 0.5);
  EXPECT_EQ(robot.name, "robot");
}

TEST_F(ConfigTest, ALaterFileOverridesAnEarlierOneKeyByKey) {
  config.load(
      {file("[robot]\ncount = 4\nname = first\n", "a.ini"), file("[robot]\ncount = 5\n", "b.ini")});
  EXPECT_EQ(robot.count, 5);
  EXPECT_EQ(robot.name, "first");
}

TEST_F(ConfigTest, AnOverrideComesAfterAllFiles) {
  config.load({file("[robot]\ncount = 4\n")}, {"robot.count=9", "wall:left.height_m=1.5"});
  EXPECT_EQ(robot.count, 9);
  EXPECT_EQ(walls.at("left").height_m, 1.5);
}

TEST_F(ConfigTest, AnOverrideValueMayHoldDotsAndEqualSigns) {
  config.load({}, {"robot.name=a.b=c"});
  EXPECT_EQ(robot.name, "a.b=c");
}

TEST_F(ConfigTest, RepeatedSectionsMakeOneEntryEach) {
  config.load({file("[wall:left]\nheight_m = 1\n[wall:right]\n", "a.ini"),
               file("[wall:left]\nheight_m = 3\n", "b.ini")});
  ASSERT_EQ(walls.size(), 2u);
  EXPECT_EQ(walls.at("left").height_m, 3.0);
  EXPECT_EQ(walls.at("right").height_m, 2.0);  // the default
}

/** As MRPT's programs have them: whatever keys they need. */
TEST_F(ConfigTest, SectionsWithAMarkerAreTakenOverAsTheyAre) {
  std::map<std::string, Config::FreeSection> drivers;
  config.bindFree("driver", "A sensor.", drivers);
  config.load({file("[front]\ndriver = CHokuyoURG\nCOM_port_LIN = /dev/ttyACM0\n", "a.ini"),
               file("[front]\npose_x = 0.1\n[robot]\ncount = 4\n", "b.ini")},
              {"front.pose_x=0.2"});
  EXPECT_EQ(robot.count, 4);
  ASSERT_EQ(drivers.size(), 1u);
  EXPECT_THAT(drivers.at("front"),
              ElementsAre(Pair("COM_port_LIN", "/dev/ttyACM0"), Pair("driver", "CHokuyoURG"),
                          Pair("pose_x", "0.2")));
  std::ostringstream printed;
  config.print(printed);
  EXPECT_THAT(printed.str(), HasSubstr("[front]\nCOM_port_LIN = /dev/ttyACM0\n"));
  mrpt::config::CConfigFileMemory copy;
  config.copyTo(copy);
  EXPECT_EQ(copy.read_string("front", "driver", ""), "CHokuyoURG");
  EXPECT_THROW(config.load({file("[back]\npose_x = 0.1\n")}), Error);
}

TEST_F(ConfigTest, DefinesAndExpressionsAreEvaluated) {
  load("@define HALF 1.5\n[robot]\nspeed_mps = ${HALF}\ncount = $eval{2*HALF}\n");
  EXPECT_EQ(robot.speed_mps, 1.5);
  EXPECT_EQ(robot.count, 3);
}

TEST_F(ConfigTest, ALineGoesOnAfterABackslash) {
  load("[robot]\noutline_m = 1 2, \\\n 3 4\nname = next\n");
  EXPECT_THAT(robot.outline, ElementsAre(mrpt::math::TPoint2D{1, 2}, mrpt::math::TPoint2D{3, 4}));
  EXPECT_EQ(robot.name, "next");
}

TEST_F(ConfigTest, ReadsFilesWithWindowsLineEnds) {
  load("; comment\r\n[robot]\r\n\r\ncount = 4\r\nname = a\r\n");
  EXPECT_EQ(robot.count, 4);
  EXPECT_EQ(robot.name, "a");
}

TEST_F(ConfigTest, AnEmptyFileChangesNothing) {
  const std::string before = printed();
  load("");
  load("; a comment only\n# and another\n");
  EXPECT_EQ(printed(), before);
}

TEST_F(ConfigTest, PrintsUnitDefaultAndAcceptedValues) {
  load("[robot]\nspeed_mps = 2\n");
  EXPECT_THAT(printed(), HasSubstr("; The robot.\n[robot]\n"
                                   "; a speed (unit: m/s; default: 0.5; a number from -10 to 10)\n"
                                   "speed_mps = 2\n"));
  EXPECT_THAT(printed(), HasSubstr("default: green; one of red | green)\ncolour = green\n"));
}

TEST_F(ConfigTest, RefusesACheckOfSeveralKeysByName) {
  try {
    Config::refuse("robot", "count", "at least [wall] count");
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("[robot] count: expected at least [wall] count"));
    EXPECT_EQ(error.exitCode(), 2);
  }
}

}  // namespace
}  // namespace bslnav::test
