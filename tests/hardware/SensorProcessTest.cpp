#include <ScipEmulator.h>
#include <bslnav/hardware/Sensors.h>
#include <gmock/gmock.h>
#include <mrpt/core/Clock.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <thread>

namespace bslnav::test {
namespace {

using testing::HasSubstr;

bool waitUntil(double seconds, const std::function<bool()>& condition) {
  for (int k = 0; k < static_cast<int>(seconds / 0.02); ++k) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return condition();
}

SensorProcess::Options options() {
  SensorProcess::Options options;
  options.program = BSLNAV_SENSOR_PROGRAM;
  options.again_s = 0.2;
  return options;
}

Config::FreeSection hokuyoAt(const std::string& port) {
  return {{"driver", "CHokuyoURG"},
          {"process_rate", "500"},
          {"COM_port_LIN", port},
          {"comms_timeout_ms", "50"},
          {"disable_firmware_timestamp", "true"}};
}

/** A laser that sees 2 m everywhere. */
struct Laser : ScipEmulator {
  Laser() : ScipEmulator(ScipModel::urg04lx()) {
    setRanges(std::vector<float>(static_cast<std::size_t>(model().beams()), 2.0f));
  }
};

TEST(SensorProcess, DeliversWhatTheDriverObserves) {
  const Laser laser;
  SensorProcess process("front", hokuyoAt(laser.path()), options());
  std::vector<mrpt::obs::CObservation::Ptr> got;
  ASSERT_TRUE(waitUntil(30.0, [&] { return !(got = process.take()).empty(); }));
  EXPECT_EQ(got[0]->sensorLabel, "front");
  const auto& scan = dynamic_cast<const mrpt::obs::CObservation2DRangeScan&>(*got[0]);
  EXPECT_NEAR(scan.getScanRange(300), 2.0f, 1e-3f);
  EXPECT_EQ(process.status().trouble, "");
  EXPECT_EQ(process.status().starts, 1);
}

TEST(SensorProcess, TellsWhatTheDriverComplainsOf) {
  SensorProcess unknown("front", {{"driver", "CNoSuchLaser"}}, options());
  SensorProcess absent("back", hokuyoAt("/dev/no_such_port"), options());
  EXPECT_TRUE(waitUntil(30.0, [&] { return unknown.status().starts > 1; }));
  EXPECT_THAT(unknown.status().trouble, HasSubstr("no driver 'CNoSuchLaser'"));
  EXPECT_TRUE(waitUntil(30.0, [&] { return absent.status().starts > 1; }));
  EXPECT_THAT(absent.status().trouble, HasSubstr("/dev/no_such_port"));
}

/** MRPT's OpenNI2 driver aborts its process where there is no camera. */
TEST(SensorProcess, ADriverThatCrashesTakesNobodyWithIt) {
  SensorProcess process("depth", {{"driver", "COpenNI2Sensor"}}, options());
  EXPECT_TRUE(waitUntil(30.0, [&] { return process.status().starts > 1; }));
  EXPECT_NE(process.status().trouble, "");
  EXPECT_TRUE(process.take().empty());
}

TEST(SensorProcess, AProgramThatIsNotThereIsTrouble) {
  auto missing = options();
  missing.program = "/no/such/bslnav-sensor";
  SensorProcess process("front", hokuyoAt("/dev/null"), missing);
  EXPECT_TRUE(waitUntil(30.0, [&] { return !process.status().trouble.empty(); }));
  EXPECT_THAT(process.status().trouble, HasSubstr("/no/such/bslnav-sensor"));
}

TEST(SensorProcess, AProgramThatWritesNonsenseIsEndedAndStartedAgain) {
  auto other = options();
  other.program = "/bin/echo";
  {
    SensorProcess process("front", {}, other);
    EXPECT_TRUE(waitUntil(30.0, [&] { return process.status().starts > 1; }));
    EXPECT_THAT(process.status().trouble, HasSubstr("makes no sense"));
  }
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);  // none is left
}

/** Its section is longer than a pipe holds, so that it surely ends before it could be given all. */
TEST(SensorProcess, AProgramThatEndsBeforeItReadsItsSectionIsHeard) {
  auto other = options();
  other.program = "/bin/echo";
  SensorProcess process("front", {{"long", std::string(1 << 20, 'x')}}, other);
  EXPECT_TRUE(waitUntil(30.0, [&] { return process.status().starts > 1; }));
  EXPECT_THAT(process.status().trouble, HasSubstr("makes no sense"));
}

/** MRPT's driver never finds out by itself that a laser was silent from the start. */
TEST(SensorProcess, ALaserThatIsSilentFromTheStartIsTrouble) {
  Laser laser;
  laser.goSilent(true);
  SensorProcess process("front", hokuyoAt(laser.path()), options());
  ASSERT_TRUE(waitUntil(30.0, [&] { return process.status().starts > 1; }));
  EXPECT_THAT(process.status().trouble, HasSubstr("does not answer when it is set up"));
  laser.goSilent(false);
  EXPECT_TRUE(waitUntil(30.0, [&] { return !process.take().empty(); }));
}

/** It needs 2 s from its start to the first scan: 0.7 s are enough after some starts in vain. */
TEST(SensorProcess, ASlowDriverIsGivenMoreTimeEachTime) {
  const Laser laser;
  auto impatient = options();
  impatient.silence_s = 0.7;
  SensorProcess process("front", hokuyoAt(laser.path()), impatient);
  EXPECT_TRUE(waitUntil(30.0, [&] { return !process.take().empty(); }));
  EXPECT_GT(process.status().starts, 1);
}

TEST(Sensors, PutTheNewestOfEachIntoAFrameAndReport) {
  const Laser laser;
  SensorsParameters parameters;
  parameters.stamps.frozen_s = 0.0;  // the emulated ranges have no noise
  Sensors sensors({{"front", hokuyoAt(laser.path())}}, parameters, BSLNAV_SENSOR_PROGRAM, "");
  SensorFrame frame;
  const double start_s = mrpt::Clock::nowDouble();
  const auto collects = [&] {
    frame.startTime_s = start_s;
    frame.time_s = mrpt::Clock::nowDouble() - start_s;
    sensors.collect(frame);
    return !frame.scans.empty();
  };
  for (int k = 0; k < 30; ++k) ASSERT_TRUE(waitUntil(30.0, collects));
  EXPECT_EQ(frame.scans.size(), 1u);
  const auto report = sensors.reports().at(0);
  EXPECT_EQ(report.name, "front");
  EXPECT_EQ(report.driver, "CHokuyoURG");
  EXPECT_GE(report.frames, 30);
  EXPECT_GT(report.rate_hz, 3.0);
  EXPECT_LT(report.rate_hz, 15.0);
  EXPECT_EQ(report.trouble, "");
  EXPECT_GT(report.latency_s, 0.0);
}

TEST(Sensors, RefuseAFrozenLaser) {
  const Laser laser;
  Sensors sensors({{"front", hokuyoAt(laser.path())}}, {}, BSLNAV_SENSOR_PROGRAM, "");
  SensorFrame frame;
  const double start_s = mrpt::Clock::nowDouble();
  EXPECT_TRUE(waitUntil(30.0, [&] {
    frame.startTime_s = start_s;
    frame.time_s = mrpt::Clock::nowDouble() - start_s;
    sensors.collect(frame);
    return sensors.reports().at(0).refused > 0;
  }));
  EXPECT_TRUE(frame.scans.empty());
  EXPECT_THAT(sensors.reports().at(0).trouble, HasSubstr("repeated one scan"));
}

/** Nothing is lost by it, and some drivers are cured. */
TEST(Sensors, StartADriverAgainOfWhichAllIsRefused) {
  Laser laser;
  SensorsParameters parameters;
  parameters.silence_s = 6.0;  // it takes the driver 2 s to start
  Sensors sensors({{"front", hokuyoAt(laser.path())}}, parameters, BSLNAV_SENSOR_PROGRAM, "");
  SensorFrame frame;
  const double start_s = mrpt::Clock::nowDouble();
  const auto collect = [&] {
    frame.startTime_s = start_s;
    frame.time_s = mrpt::Clock::nowDouble() - start_s;
    sensors.collect(frame);
    return sensors.reports().at(0);
  };
  ASSERT_TRUE(waitUntil(30.0, [&] { return collect().refused > 0; }));  // it repeats one scan
  EXPECT_EQ(collect().starts, 1);
  ASSERT_TRUE(waitUntil(30.0, [&] { return collect().starts > 1; }));
  const int frames = collect().frames;
  float range_m = 2.0f;
  EXPECT_TRUE(waitUntil(30.0, [&] {
    const auto beams = static_cast<std::size_t>(laser.model().beams());
    laser.setRanges(std::vector<float>(beams, range_m += 0.001f));
    return collect().frames > frames + 3;
  }));
}

}  // namespace
}  // namespace bslnav::test
