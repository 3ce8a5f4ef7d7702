#include <bslnav/hardware/CreateProtocol.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

namespace bslnav::test {
namespace {

std::string bytes(std::initializer_list<int> values) {
  std::string result;
  for (const int value : values) result += static_cast<char>(value);
  return result;
}

/** Bump on the right, safe mode, left 1000 = 0x03E8 counts, right -1 = 0xFFFF. All but the last
 * byte sum to 956 = 3 * 256 + 188, and 188 + 68 = 256. */
const std::string kFrame =
    bytes({19, 18, 7, 1, 9, 0, 10, 0, 11, 0, 12, 0, 35, 2, 43, 3, 232, 44, 255, 255, 68});

std::vector<CreateSensors> parsed(CreateFrameParser& parser, const std::string& text) {
  std::vector<CreateSensors> found;
  for (const char byte : text)
    if (const auto sensors = parser.feed(static_cast<std::uint8_t>(byte)))
      found.push_back(*sensors);
  return found;
}

std::string with(std::size_t at, int value) {
  std::string frame = kFrame;
  frame[at] = static_cast<char>(value);
  frame.back() = 0;
  frame.back() = static_cast<char>(create::checksum(frame));
  return frame;
}

CreateSensors sensorsOf(const std::string& frame) {
  CreateFrameParser parser;
  return parsed(parser, frame).at(0);
}

TEST(CreateProtocol, DriveDirectIsRightThenLeftInMillimetresPerSecond) {
  // 200 = 0x00C8; -100 = 0xFF9C
  EXPECT_EQ(create::driveDirect({-0.1, 0.2}), bytes({145, 0x00, 0xC8, 0xFF, 0x9C}));
  // +-500 = 0x01F4, 0xFE0C is all that the robot takes.
  EXPECT_EQ(create::driveDirect({-9.0, 9.0}), bytes({145, 0x01, 0xF4, 0xFE, 0x0C}));
}

TEST(CreateProtocol, StartsAndAsksForTheStream) {
  EXPECT_EQ(create::start(), bytes({128}));
  EXPECT_EQ(create::safe(), bytes({131}));
  EXPECT_EQ(create::stream(), bytes({148, 8, 7, 9, 10, 11, 12, 35, 43, 44}));
}

TEST(CreateProtocol, ChecksumIsThatOfTheSpecificationsExample) {
  // "19 5 29 2 25 13 0 163": packets 29 and 13
  EXPECT_EQ(create::checksum(bytes({19, 5, 29, 2, 25, 13, 0})), 163);
  EXPECT_EQ(create::checksum(bytes({19, 5, 29, 2, 25, 13, 0, 163})), 0);
}

TEST(CreateFrameParser, ReadsAFrame) {
  const CreateSensors sensors = sensorsOf(kFrame);
  EXPECT_TRUE(sensors.bumpRight);
  EXPECT_FALSE(sensors.bumpLeft || sensors.wheelDrop || sensors.cliff);
  EXPECT_EQ(sensors.mode, 2);
  EXPECT_EQ(sensors.leftCounts, 1000);
  EXPECT_EQ(sensors.rightCounts, 65535);
}

TEST(CreateSensors, TellWhyTheRobotStands) {
  EXPECT_EQ(sensorsOf(kFrame).halt(), "bump right");
  EXPECT_EQ(sensorsOf(with(3, 0)).halt(), "");
  EXPECT_EQ(sensorsOf(with(3, 2)).halt(), "bump left");
  EXPECT_EQ(sensorsOf(with(3, 3)).halt(), "bump ahead");
  for (const int drop : {4, 8})
    EXPECT_EQ(sensorsOf(with(3, drop)).halt(), "wheel drop: lifted, or over an edge");
  for (const std::size_t cliff : {5, 7, 9, 11})
    EXPECT_EQ(sensorsOf(with(cliff, 1)).halt(), "cliff");
}

TEST(CreateSensors, APassiveRobotTakesNoCommands) {
  std::string frame = with(3, 0);
  frame[13] = 1;
  frame.back() = static_cast<char>(frame.back() + 1);
  EXPECT_FALSE(sensorsOf(frame).takesCommands());
  EXPECT_EQ(sensorsOf(frame).halt(), "takes no commands: Open Interface mode 1");
}

TEST(CreateFrameParser, DropsAndCountsAFrameWithABadChecksum) {
  CreateFrameParser parser;
  std::string damaged = kFrame;
  ++damaged[16];
  EXPECT_TRUE(parsed(parser, damaged).empty());
  EXPECT_EQ(parser.badChecksums(), 1u);
  EXPECT_EQ(parsed(parser, kFrame).size(), 1u);
  EXPECT_EQ(parser.badChecksums(), 1u);
}

TEST(CreateFrameParser, AHeaderThatIsNoneCostsNothing) {
  CreateFrameParser parser;
  EXPECT_EQ(parsed(parser, bytes({19, 19, 18, 7, 19}) + kFrame).size(), 1u);
}

std::string garbage() {
  const auto byte = rc::gen::oneOf(rc::gen::inRange(0, 256), rc::gen::element(19, 18, 7));
  std::string result;
  for (const int value : *rc::gen::container<std::vector<int>>(byte))
    result += static_cast<char>(value);
  return result;
}

RC_GTEST_PROP(CreateFrameParserLaw, NoGarbageBetweenFramesLosesAFrame, ()) {
  CreateFrameParser parser;
  for (int i = 0; i < 5; ++i)
    RC_ASSERT(parsed(parser, garbage() + with(16, i)).back().leftCounts == 0x0300 + i);
}

RC_GTEST_PROP(CreateFrameParserLaw, LostBytesLoseTheirFrameAlone, ()) {
  CreateFrameParser parser;
  const auto from = static_cast<std::size_t>(*rc::gen::inRange(0, 21));
  const auto count = static_cast<std::size_t>(*rc::gen::inRange(1, 21));
  std::string cut = kFrame;
  cut.erase(from, count);
  RC_ASSERT(parsed(parser, kFrame + cut + kFrame).size() == 2u);
}

}  // namespace
}  // namespace bslnav::test
