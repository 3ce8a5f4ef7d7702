#include "ConfigFixture.h"

namespace bslnav::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST_F(ConfigTest, RefusesAnUnknownKeyAndSuggestsTheNearest) {
  EXPECT_THAT(refusal("[robot]\nspeed_mp = 1\n"),
              AllOf(HasSubstr("config.ini [robot] speed_mp: unknown key"),
                    HasSubstr("did you mean 'speed_mps'?")));
}

TEST_F(ConfigTest, RefusesAnUnknownSectionAndSuggestsTheNearest) {
  EXPECT_THAT(refusal("[robbot]\ncount = 1\n"),
              AllOf(HasSubstr("[robbot]: unknown section"), HasSubstr("did you mean 'robot'?")));
}

TEST_F(ConfigTest, RefusesAnUnknownSectionWithoutKeys) {
  EXPECT_THAT(refusal("[robbot]\n"), HasSubstr("[robbot]: unknown section"));
}

TEST_F(ConfigTest, RefusesARepeatedSectionWithoutName) {
  EXPECT_THAT(refusal("[wall:]\nheight_m = 1\n"), HasSubstr("unknown section"));
}

TEST_F(ConfigTest, SuggestsNothingForWordsFarFromAll) {
  EXPECT_THAT(refusal("[robot]\nzzzzzzzz = 1\n"), testing::Not(HasSubstr("did you mean")));
}

struct BadValue {
  const char *name, *line, *problem;
  friend std::ostream& operator<<(std::ostream& out, const BadValue& value) {
    return out << value.line;
  }
};
class ConfigBadValue : public ConfigTest, public testing::WithParamInterface<BadValue> {};

TEST_P(ConfigBadValue, IsRefusedNamingTheKeyAndChangesNothing) {
  const std::string line = GetParam().line, key = line.substr(0, line.find(' '));
  const std::string before = printed();
  EXPECT_THAT(
      refusal("[robot]\n" + line + "\n"),
      AllOf(HasSubstr("[robot] " + key), HasSubstr(GetParam().problem), HasSubstr("expected")));
  EXPECT_EQ(printed(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Config, ConfigBadValue,
    testing::Values(BadValue{"word", "speed_mps = fast", "not a number"},
                    BadValue{"empty", "speed_mps =", "not a number"},
                    BadValue{"unitBehind", "speed_mps = 1 m", "not a number"},
                    BadValue{"commentBehind", "speed_mps = 1 ; slow", "not a number"},
                    BadValue{"comma", "speed_mps = 0,5", "not a number"},
                    BadValue{"notANumber", "speed_mps = nan", "not finite"},
                    BadValue{"infinite", "speed_mps = inf", "not finite"},
                    BadValue{"tooHigh", "speed_mps = 10.001", "out of range"},
                    BadValue{"tooLow", "speed_mps = -10.001", "out of range"},
                    BadValue{"angleInDegrees", "angle_deg = 181", "out of range"},
                    BadValue{"fraction", "count = 2.5", "not a whole number"},
                    BadValue{"tooMany", "count = 101", "out of range"},
                    BadValue{"flag", "enabled = yes", "one of false | true"},
                    BadValue{"choice", "colour = blue", "one of red | green"},
                    BadValue{"tooFewPoints", "outline_m = 1 2", "too few points"},
                    BadValue{"oddPoint", "outline_m = 1 2, 3", "wrong count of numbers"},
                    BadValue{"cutOff", "outline_m = 1 2, 3 4,", "cut off after a comma"},
                    BadValue{"listValue", "speeds_mps = 1, -2", "out of range"},
                    BadValue{"twoPoses", "start = 1 2 3, 4 5 6", "not one pose"},
                    BadValue{"poseWithoutHeading", "goals = 1 2", "wrong count of numbers"}),
    [](const auto& value) { return value.param.name; });

TEST_F(ConfigTest, RefusesAMissingFile) {
  EXPECT_THROW(
      {
        try {
          config.load({testing::TempDir() + "/bslnav_no_such_file.ini"});
        } catch (const Error& error) {
          EXPECT_THAT(error.what(), HasSubstr("bslnav_no_such_file.ini: no such file"));
          throw;
        }
      },
      Error);
}

TEST_F(ConfigTest, RefusesADirectory) { EXPECT_THROW(config.load({testing::TempDir()}), Error); }

TEST_F(ConfigTest, RefusesALineThatIsNoAssignment) {
  EXPECT_THAT(refusal("[robot]\ncount = 1\nspeed_mps 2\n"),
              HasSubstr("config.ini:3: expected key = value"));
}

TEST_F(ConfigTest, CountsContinuedLinesWhenItNamesALine) {
  EXPECT_THAT(refusal("[robot]\nspeeds_mps = 1, \\\n 2\nlost\n"),
              HasSubstr("config.ini:4: expected key"));
}

TEST_F(ConfigTest, RefusesAnAssignmentWithoutKey) {
  EXPECT_THAT(refusal("[robot]\n = 2\n"), HasSubstr("config.ini:2: expected key = value"));
}

TEST_F(ConfigTest, RefusesAKeyBeforeAnySection) {
  EXPECT_THAT(refusal("count = 1\n[robot]\n"), HasSubstr("config.ini:1: a key before any section"));
}

TEST_F(ConfigTest, RefusesASectionThatIsNotClosed) {
  EXPECT_THAT(refusal("[robot\ncount = 1\n"), HasSubstr("config.ini:1: malformed section"));
}

TEST_F(ConfigTest, RefusesTextBehindASection) {
  EXPECT_THAT(refusal("[robot] count = 1\n"), HasSubstr("config.ini:1: malformed section"));
}

TEST_F(ConfigTest, RefusesASectionWithoutName) {
  EXPECT_THAT(refusal("[ ]\n"), HasSubstr("config.ini:1: a section without a name"));
}

TEST_F(ConfigTest, RefusesAKeyGivenTwice) {
  EXPECT_THAT(refusal("[robot]\ncount = 1\ncount = 2\n"),
              HasSubstr("config.ini:3 [robot] count: given twice"));
}

TEST_F(ConfigTest, RefusesAKeyGivenTwiceInPartsOfASection) {
  EXPECT_THAT(refusal("[robot]\ncount = 1\n[wall:a]\n[robot]\nCount = 2\n"),
              HasSubstr("given twice"));
}

TEST_F(ConfigTest, RefusesAnUndefinedVariable) {
  EXPECT_NE(refusal("[robot]\ncount = ${NOWHERE}\n"), "");
}

TEST_F(ConfigTest, RefusesBinaryFiles) {
  std::string noise = "[robot]\n";
  unsigned state = 1;
  for (int i = 0; i < 2000; ++i)
    noise += static_cast<char>((state = state * 1103515245u + 12345u) >> 16);
  EXPECT_NE(refusal(noise), "");
  EXPECT_THAT(refusal(std::string("[robot]\nname = a\0b\n", 19)), HasSubstr("binary data"));
}

TEST_F(ConfigTest, RefusesOverridesThatAreNotSectionKeyValue) {
  for (const char* text :
       {"robot.count", "count=1", ".count=1", "robot.=1", "=", "", "robot.cuont=1"})
    EXPECT_THROW(config.load({}, {text}), Error) << text;
}

}  // namespace
}  // namespace bslnav::test
