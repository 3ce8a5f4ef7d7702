#include <ScipLaser.h>
#include <gmock/gmock.h>

#include <limits>

namespace bslnav::test {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

/** Four steps, so that a packet can be written out. */
ScipModel small() {
  auto model = ScipModel::urg04lx();
  model.lastStep = model.firstStep + 3;
  return model;
}

const std::vector<float> kRanges_m{5.432f, 0.01f, kNothing, 5.6f};

TEST(ScipLaser, NumbersAreThoseOfTheSpecification) {
  EXPECT_EQ(scipNumber(5432, 3), "1Dh");
  EXPECT_EQ(scipNumber(16000000, 4), "m2@0");
}

TEST(ScipLaser, FactsHaveTheCheckSumsOfARealOne) {
  ScipLaser laser(ScipModel::urg04lx());
  EXPECT_EQ(laser.answer("PP"),
            "PP\n00P\nMODL:URG-04LX(Hokuyo Automatic Co.,Ltd.);N\nDMIN:20;4\nDMAX:5600;_\n"
            "ARES:1024;\\\nAMIN:44;7\nAMAX:725;o\nAFRT:384;6\nSCAN:600;e\n\n");
  EXPECT_THAT(laser.answer("VV"), testing::HasSubstr("\nPROT:SCIP 2.0;N\n"));
  EXPECT_THAT(laser.answer("II"), testing::HasSubstr("\nLASR:OFF;7\n"));
}

TEST(ScipLaser, CommandsAreAnswered) {
  ScipLaser laser(small());
  EXPECT_EQ(laser.answer("BM"), "BM\n00P\n\n");
  EXPECT_EQ(laser.answer("BM"), "BM\n02R\n\n");  // it was on
  EXPECT_EQ(laser.answer("QT"), "QT\n00P\n\n");
  EXPECT_EQ(laser.answer("SS115200"), "SS115200\n00P\n\n");
  EXPECT_EQ(laser.answer("XY"), "XY\n0Ee\n\n");                            // undefined
  EXPECT_EQ(laser.answer("MD0044004701"), "MD0044004701\n0Cc\n\n");        // too short
  EXPECT_EQ(laser.answer("MD0044004801000"), "MD0044004801000\n04T\n\n");  // past the last step
}

TEST(ScipLaser, APacketHasEchoStatusClockAndRanges) {
  auto model = small();
  model.clockAtStart_ms = 16000000;
  ScipLaser laser(model);
  laser.answer("MD0044004701000");
  // 5432 mm; too near: 19 = "00C"; nothing there: 0; at the maximum: nothing there.
  EXPECT_EQ(laser.turn(kRanges_m), "MD0044004701000\n99b\nm2@0?\n1Dh00C000000P\n\n");
}

TEST(ScipLaser, LinesHave64CharactersAtMost) {
  auto model = small();
  model.lastStep = model.firstStep + 21;
  ScipLaser laser(model);
  laser.answer("MD0044006501000");  // 22 steps: 66 characters
  const std::vector<float> nothing(22, kNothing);
  EXPECT_EQ(laser.turn(nothing),
            "MD0044006501000\n99b\n00000\n" + std::string(64, '0') + "0\n00P\n\n");
}

TEST(ScipLaser, StepsIntervalAndCountAreRespected) {
  ScipLaser laser(small());
  laser.answer("MD0044004501102");  // two steps, every second turn, two scans
  EXPECT_THAT(laser.turn(kRanges_m), testing::StartsWith("MD0044004501101\n99b\n"));
  EXPECT_EQ(laser.turn(kRanges_m), "");
  // The clock of the third turn is 200 ms = "0038".
  EXPECT_EQ(laser.turn(kRanges_m), "MD0044004501100\n99b\n0038;\n1Dh00C0\n\n");
  EXPECT_EQ(laser.turn(kRanges_m), "");
  EXPECT_EQ(laser.turn(kRanges_m), "");
}

TEST(ScipLaser, QuitResetAndBeamOnEndTheScans) {
  for (const char* command : {"QT", "RS", "BM"}) {
    ScipLaser laser(small());
    laser.answer("MD0044004701000");
    ASSERT_NE(laser.turn(kRanges_m), "");
    laser.answer(command);
    EXPECT_EQ(laser.turn(kRanges_m), "") << command;
  }
}

TEST(ScipLaser, TheClockWrapsAt24Bits) {
  auto model = small();
  model.clockAtStart_ms = 0xffffff;
  ScipLaser laser(model);
  laser.answer("MD0044004701000");
  EXPECT_THAT(laser.turn(kRanges_m), testing::HasSubstr("\noooo"));
  EXPECT_THAT(laser.turn(kRanges_m), testing::HasSubstr("\n001S"));  // 99 ms = 1·64 + 35
}

}  // namespace
}  // namespace bslnav::test
