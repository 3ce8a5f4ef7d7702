#include <ScipEmulator.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "DrivenLaser.h"

// What MRPT's driver makes of a laser's faults: supervision is built on that.
namespace bslnav::test {
namespace {

using mrpt::hwdrivers::CGenericSensor;
using testing::HasSubstr;

bool allAt(const DrivenLaser::Scan& scan, float range_m) {
  for (std::size_t i = 0; i < scan->getScanSize(); ++i)
    if (std::abs(scan->getScanRange(i) - range_m) > 1e-4f) return false;
  return true;
}

/** Faster than any real one, for short tests: at 12.5 ms a scan comes well within the driver's
 * timeout of 50 ms. If none did, the driver would give up again as soon as it has reconnected. */
ScipModel fast() {
  ScipModel model;
  model.speed_rpm = 4800;
  return model;
}

/** A laser in the middle of its work. */
struct ScipFaults : testing::Test {
  void SetUp() override {
    emulator.setRanges(std::vector<float>(1081, 2.0f));
    laser.emplace(emulator.path());
    ASSERT_EQ(laser->scans(15).size(), 15u);  // by then the driver counts by the laser's clock
  }

  void expectScans() {
    const auto scans = laser->scans(5);
    ASSERT_EQ(scans.size(), 5u);
    EXPECT_TRUE(allAt(scans.back(), 2.0f));
    EXPECT_FALSE(laser->failed());
  }
  void waitForError() {
    laser->waitFor(CGenericSensor::ssError);
    ASSERT_TRUE(laser->failed());
  }

  ScipEmulator emulator{fast()};
  std::optional<DrivenLaser> laser;
};

TEST_F(ScipFaults, GarbageBetweenPacketsIsSkipped) {
  emulator.sendGarbage(500);
  const auto scans = laser->scans(10);
  ASSERT_EQ(scans.size(), 10u);
  EXPECT_TRUE(std::all_of(scans.begin(), scans.end(), [](auto& s) { return allAt(s, 2.0f); }));
  EXPECT_EQ(laser->complaints(), "");
}

TEST_F(ScipFaults, AHalfPacketCostsTheNextOneToo) {
  emulator.halveNextPacket();
  waitForError();
  EXPECT_THAT(laser->complaints(), HasSubstr("Expected 3247 data bytes"));
  expectScans();
}

// The driver does not drop what it cannot read there, and reads it again until it has had enough.
TEST_F(ScipFaults, APacketCutInItsStatusMakesTheDriverConnectAnew) {
  emulator.cutNextPacket(17);  // the echo has 16
  waitForError();
  EXPECT_THAT(laser->complaints(), Not(HasSubstr("data bytes")));
  expectScans();
}

TEST_F(ScipFaults, DamagedRangesPassForGoodOnes) {
  emulator.garbleNextPacket(0.05);
  const auto scans = laser->scans(10);
  ASSERT_EQ(scans.size(), 10u);
  EXPECT_EQ(std::count_if(scans.begin(), scans.end(), [](auto& s) { return allAt(s, 2.0f); }), 9);
  EXPECT_FALSE(laser->failed());
  EXPECT_EQ(laser->complaints(), "");
}

TEST_F(ScipFaults, FrozenRangesPassForGoodOnes) {
  emulator.freeze(ScipEmulator::Frozen::Ranges);
  laser->scans(5);
  emulator.setRanges(std::vector<float>(1081, 3.0f));
  const auto scans = laser->scans(20);
  ASSERT_EQ(scans.size(), 20u);
  EXPECT_TRUE(allAt(scans.back(), 2.0f));
  EXPECT_GT(scans.back()->timestamp, scans.front()->timestamp);
  EXPECT_FALSE(laser->failed());
  emulator.freeze(ScipEmulator::Frozen::Not);
  const auto after = laser->scans(20);
  EXPECT_TRUE(!after.empty() && allAt(after.back(), 3.0f));
}

TEST_F(ScipFaults, AFrozenPacketStopsTheStampsAlone) {
  emulator.freeze(ScipEmulator::Frozen::Packet);
  laser->scans(20);
  const auto scans = laser->scans(5);
  ASSERT_EQ(scans.size(), 5u);
  EXPECT_EQ(scans.back()->timestamp, scans.front()->timestamp);
  EXPECT_FALSE(laser->failed());
}

TEST_F(ScipFaults, SilenceIsAnErrorUntilTheLaserSpeaksAgain) {
  emulator.goSilent(true);
  waitForError();
  laser->driver().doProcess();
  EXPECT_TRUE(laser->failed());
  emulator.goSilent(false);
  expectScans();
}

// By the difference of unsigned 32 bit milliseconds: 2^32 ms = 49.7 days. The same happens when the
// laser's clock wraps.
TEST(ScipFaultsClock, AClockThatStartsAnewPutsScansInTheFuture) {
  auto model = fast();
  model.clockAtStart_ms = 1000000;
  ScipEmulator emulator(model);
  DrivenLaser laser(emulator.path());
  ASSERT_EQ(laser.scans(15).size(), 15u);
  emulator.restart();
  laser.waitFor(CGenericSensor::ssError);
  const auto scans = laser.scans(1);
  ASSERT_EQ(scans.size(), 1u);
  const double ahead_s = mrpt::system::timeDifference(mrpt::Clock::now(), scans[0]->timestamp);
  EXPECT_NEAR(ahead_s, 4294967.296 - 1000.0, 60.0);
}

TEST(ScipFaultsSilence, FromTheStartTheDriverNeitherTellsNorRecovers) {
  ScipEmulator emulator(fast());
  emulator.goSilent(true);
  DrivenLaser laser(emulator.path());
  EXPECT_TRUE(laser.failed());
  EXPECT_TRUE(laser.scans(1, 0.2).empty());
  EXPECT_EQ(laser.driver().getState(), CGenericSensor::ssWorking);
  emulator.goSilent(false);
  EXPECT_TRUE(laser.scans(1, 1.0).empty());
  EXPECT_EQ(laser.driver().getState(), CGenericSensor::ssWorking);
  laser.driver().initialize();
  EXPECT_EQ(laser.scans(3).size(), 3u);
}

TEST_F(ScipFaults, APulledCableIsAnError) {
  emulator.pullCable();
  waitForError();
  EXPECT_THAT(laser->complaints(), HasSubstr("Serial port connection lost"));
  EXPECT_NO_THROW(laser->driver().doProcess());
  EXPECT_NO_THROW(laser->driver().initialize());
  EXPECT_TRUE(laser->failed());
}

TEST_F(ScipFaults, ACablePulledWhileTheDriverConnectsAnewMakesItThrow) {
  emulator.goSilent(true);
  waitForError();
  emulator.pullCable();
  for (int i = 0; i < 2; ++i) EXPECT_THROW(laser->driver().doProcess(), std::exception);
  EXPECT_TRUE(laser->failed());
}

TEST(ScipFaultsCable, WithoutAPortTheDriverThrowsAtOnce) {
  EXPECT_THROW(DrivenLaser(testing::TempDir() + "no-such-port"), std::exception);
}

TEST(ScipFaultsCable, PluggedInAgainUnderTheSameNameTheDriverGoesOn) {
  const std::filesystem::path name = testing::TempDir() + "laser" + std::to_string(::getpid());
  std::filesystem::remove(name);
  std::optional<ScipEmulator> emulator(std::in_place, fast());
  std::filesystem::create_symlink(emulator->path(), name);
  DrivenLaser laser(name.string());
  ASSERT_EQ(laser.scans(3).size(), 3u);
  emulator->pullCable();
  laser.waitFor(CGenericSensor::ssError);
  ASSERT_TRUE(laser.failed());
  emulator.emplace(fast());
  std::filesystem::remove(name);
  std::filesystem::create_symlink(emulator->path(), name);
  EXPECT_EQ(laser.scans(3).size(), 3u);
  EXPECT_FALSE(laser.failed());
  std::filesystem::remove(name);
}

}  // namespace
}  // namespace bslnav::test
