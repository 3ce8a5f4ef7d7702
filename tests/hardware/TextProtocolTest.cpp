#include <bslnav/hardware/TextProtocol.h>
#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>

namespace bslnav {
namespace {

using testing::EndsWith;

TextState anyState() { return {12345, {1.5, -2.25, 0.5}, {0.3, 0.0, -0.1}, "", {}}; }

template <typename Message>
Message read(std::string line) {
  line.pop_back();
  return std::get<Message>(fromTextLine(line).value());
}

bool isRefused(const std::string& line) { return !fromTextLine(line); }

// The check sums are the exclusive or of what stands between $ and *. For "X" that is X itself.
TEST(TextProtocol, WritesTheLinesOfItsDocument) {
  EXPECT_EQ(toTextLine(TextStop()), "$X*58\n");
  EXPECT_EQ(toTextLine(TextHello{1, 300}), "$H,1,300*4A\n");
  EXPECT_EQ(toTextLine(TextVelocity{{0.5, 0.0, -0.25}}), "$V,0.5000,0.0000,-0.2500*4B\n");
  TextState state = anyState();
  EXPECT_EQ(toTextLine(state), "$S,12345,1.5000,-2.2500,0.5000,0.3000,0.0000,-0.1000*48\n");
  state.halt = "bumper";
  EXPECT_EQ(toTextLine(state), "$S,12345,1.5000,-2.2500,0.5000,0.3000,0.0000,-0.1000,bumper*79\n");
  state.halt.clear();
  state.mapFromRobot = {3.0, 4.0, 0.0};
  EXPECT_EQ(toTextLine(state),
            "$S,12345,1.5000,-2.2500,0.5000,0.3000,0.0000,-0.1000,,3.0000,4.0000,0.0000*51\n");
}

TEST(TextProtocol, TakesACarriageReturnAndAnEmptyHalt) {
  EXPECT_FALSE(isRefused("$X*58"));
  EXPECT_FALSE(isRefused("$X*58\r"));
  EXPECT_FALSE(isRefused("$S,1,0,0,0,0,0,0*4E"));
  EXPECT_FALSE(isRefused("$S,1,0,0,0,0,0,0,*62"));  // a comma (2C) more
}

TEST(TextProtocol, TakesTheClockUpToItsOverflow) {
  TextState state = anyState();
  state.time_ms = 4294967295U;
  EXPECT_EQ(read<TextState>(toTextLine(state)).time_ms, 4294967295U);
}

/** A line with this payload and the right check sum. */
std::string summed(const std::string& payload) {
  unsigned char sum = 0;
  for (const char c : payload)
    sum = static_cast<unsigned char>(sum ^ static_cast<unsigned char>(c));
  char hex[3];
  std::snprintf(hex, sizeof(hex), "%02X", static_cast<unsigned>(sum));
  return '$' + payload + '*' + hex;
}

TEST(TextProtocol, RefusesWhatIsNoNumberDespiteItsCheckSum) {
  for (const char* payload : {"V,nan,0,0",
                              "V,0,inf,0",
                              "V,0,0,-inf",
                              "V,1e3,0,0",
                              "V,0x1,0,0",
                              "V,+1,0,0",
                              "V, 1,0,0",
                              "V,1 ,0,0",
                              "V,,0,0",
                              "V,-,0,0",
                              "V,.,0,0",
                              "V,1.2.3,0,0",
                              "V,--1,0,0",
                              "H,1,0.3",
                              "H,-1,300",
                              "H,1,-300",
                              "H,99999999999,300",
                              "S,-1,0,0,0,0,0,0",
                              "S,4294967296,0,0,0,0,0,0",
                              "S,1.5,0,0,0,0,0,0",
                              "S,1,nan,0,0,0,0,0",
                              "S,1,0,0,0,0,0,0,,0,0,inf"})
    EXPECT_TRUE(isRefused(summed(payload))) << payload;
}

TEST(TextProtocol, RefusesOtherFieldsDespiteTheirCheckSum) {
  for (const char* payload :
       {"",
        "V",
        "V,",
        "V,0,0",
        "V,0,0,0,0",
        "V,0,0,0,",
        "v,0,0,0",
        "VV,0,0,0",
        "W,0,0,0",
        "X,",
        "X,1",
        "H,1",
        "H,1,300,1",
        "S,1,0,0,0,0,0",
        "S,1,0,0,0,0,0,0,halt,1",
        "S,1,0,0,0,0,0,0,halt,1,2",
        "S,1,0,0,0,0,0,0,halt,1,2,3,4",
        "S,1,0,0,0,0,0,0,a\tb",
        "S,1,0,0,0,0,0,0,a$b",
        "S,1,0,0,0,0,0,0,a*b",
        "S,1,0,0,0,0,0,0,\xc3\xa4",
        "S,1,0,0,0,0,0,0,1234567890123456789012345678901234567890123456789012345678901"})
    EXPECT_TRUE(isRefused(summed(payload))) << payload;
  EXPECT_FALSE(isRefused(summed("V,0,-1,.5")));
}

TEST(TextProtocol, RefusesWhatIsNoWholeLine) {
  for (const char* line :
       {"", "$", "*", "$*00", "$X", "$X*", "$X*5", "X*58", "$X58", "$X*58 ", " $X*58", "$$X*58",
        "$X*58*58", "$X*59", "$H,1,300*4a", "hello", "$X*58\r\r"})
    EXPECT_TRUE(isRefused(line)) << line;
}

TEST(TextProtocol, MakesAnUnspeakableHaltSpeakable) {
  TextState state = anyState();
  state.halt = "a,b*c$d\ne";
  EXPECT_EQ(read<TextState>(toTextLine(state)).halt, "a b c d e");
  state.halt = std::string(100, 'x');
  EXPECT_EQ(read<TextState>(toTextLine(state)).halt, std::string(kLongestTextHalt, 'x'));
}

TEST(TextProtocol, WritesNumbersThatAreNotFiniteSoThatNobodyTakesThem) {
  for (const double bad : {std::nan(""), 1.0 / 0.0, -1.0 / 0.0}) {
    std::string line = toTextLine(TextVelocity{{bad, 0.0, 0.0}});
    ASSERT_THAT(line, EndsWith("\n"));
    line.pop_back();
    EXPECT_TRUE(isRefused(line)) << line;
  }
}

TEST(TextLines, JoinsPiecesAndKeepsLittleOfALineWithoutEnd) {
  TextLines lines;
  for (const char byte : std::string("$X*")) EXPECT_FALSE(lines.take(byte));
  EXPECT_FALSE(lines.take('5'));
  EXPECT_FALSE(lines.take('8'));
  EXPECT_EQ(lines.take('\n'), "$X*58");
  for (int i = 0; i < 100000; ++i) EXPECT_FALSE(lines.take('x'));
  EXPECT_EQ(lines.take('\n')->size(), kLongestTextLine + 1);
  EXPECT_EQ(lines.take('\n'), "");
}

}  // namespace
}  // namespace bslnav
