#include <bslnav/evaluation/RawlogRun.h>
#include <bslnav/evaluation/RunRawlog.h>
#include <bslnav/navigation/RawlogReader.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CRawlog.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "EvaluationRig.h"

namespace bslnav {
namespace {

using mrpt::math::TTwist2D;
using test::hall;

constexpr std::size_t kWholeRun = 100000;

/** The name of a file of this process and test, which goes with it. */
class LogFile {
 public:
  LogFile() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = info->name();
    std::replace(name.begin(), name.end(), '/', '_');
    path_ = testing::TempDir() + "bslnav_run_" + std::to_string(getpid()) + "_" + name + ".rawlog";
  }
  ~LogFile() { std::remove(path_.c_str()); }
  LogFile(const LogFile&) = delete;
  LogFile& operator=(const LogFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/** Runs a setup and records it. */
std::vector<CycleRecord> record(const SimulationSetup& setup, const std::string& file,
                                std::size_t cycles = kWholeRun) {
  RunRawlog log(file);
  std::vector<CycleRecord> records;
  runSimulation(setup, 1, [&](const SimulationMoment& moment) {
    log.write(moment.frame);
    records.push_back(moment.record);
    return records.size() < cycles;
  });
  return records;
}

std::vector<CycleRecord> repeat(const RawlogSetup& setup) {
  std::vector<CycleRecord> records;
  evaluateLog(setup, localizeLog(setup, 1), 1, [&](const RawlogMoment& moment) {
    records.push_back(moment.record);
    return true;
  });
  return records;
}

struct Run {
  const char* name;
  std::vector<std::string> files, overrides;
  std::size_t cycles;
};

class RunRawlogRepeats : public testing::TestWithParam<Run> {
 protected:
  template <typename Setup>
  static void load(Setup& setup) {
    Config config;
    setup.bind(config);
    std::vector<std::string> files;
    for (const auto& file : GetParam().files) files.push_back(BSLNAV_SOURCE_DIR "/config/" + file);
    config.load(files, GetParam().overrides);
  }
};

/* Ranges, odometry and twist are in the log as they were. Headings of poses pass through MRPT's
 * quaternions and times through its 100 ns: both come back with an error of about 1e-16 and 1e-13,
 * which commands do not show. */
TEST_P(RunRawlogRepeats, EveryCommandOfTheRun) {
  SimulationSetup run;
  load(run);
  RawlogSetup again;
  load(again);
  const LogFile file;
  again.rawlog.file = file.path();
  const auto recorded = record(run, again.rawlog.file, GetParam().cycles);
  const auto repeated = repeat(again);
  ASSERT_EQ(repeated.size(), recorded.size());
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    const CycleRecord &a = recorded[i], &b = repeated[i];
    ASSERT_NEAR(b.time_s, a.time_s, 1e-9) << i;
    ASSERT_NEAR(b.mapFromRobot.phi, a.mapFromRobot.phi, 1e-12) << i;
    ASSERT_EQ(b.mapFromRobot.x, a.mapFromRobot.x) << i;
    ASSERT_EQ(b.twist, a.twist) << i;
    ASSERT_EQ(b.blindSpots.size(), a.blindSpots.size()) << i;
    ASSERT_EQ(b.motion.mode, a.motion.mode) << i;
    ASSERT_NEAR(b.motion.command.vx, a.motion.command.vx, 1e-9) << i;
    ASSERT_NEAR(b.motion.command.omega, a.motion.command.omega, 1e-9) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Runs, RunRawlogRepeats,
    testing::Values(Run{"S1Method2", {"scenarios/s1.ini", "methods/method2.ini"}, {}, kWholeRun},
                    Run{"S1Method4", {"scenarios/s1.ini", "methods/method4.ini"}, {}, kWholeRun},
                    // noise, delays, drift, and the poses of a particle filter
                    Run{"E1Method4", {"scenarios/e1.ini", "methods/method4.ini"}, {}, 60}),
    [](const auto& run) { return run.param.name; });

/* A control cycle of 0.1 s, the laser as fast: scan, odometry, pose, and so on. */
TEST(RunRawlog, IsARawlogOfSingleObservationsForMrpt) {
  SimulationSetup setup = hall();
  setup.lasers["front"].rate_hz = 10.0;
  const LogFile file;
  const auto records = record(setup, file.path(), 5);
  mrpt::obs::CRawlog log;
  ASSERT_TRUE(log.loadFromRawLogFile(file.path()));
  ASSERT_EQ(log.size(), 15U);
  for (std::size_t i = 0; i < 15; ++i) ASSERT_EQ(log.getType(i), mrpt::obs::CRawlog::etObservation);
  for (std::size_t cycle = 0; cycle < 5; ++cycle) {
    const auto observation = [&](std::size_t i) { return log.getAsObservation(3 * cycle + i); };
    const auto scan = std::dynamic_pointer_cast<mrpt::obs::CObservation2DRangeScan>(observation(0));
    const auto odometry =
        std::dynamic_pointer_cast<mrpt::obs::CObservationOdometry>(observation(1));
    const auto pose = std::dynamic_pointer_cast<mrpt::obs::CObservationRobotPose>(observation(2));
    ASSERT_TRUE(scan && odometry && pose);
    EXPECT_EQ(scan->sensorLabel, "front");
    EXPECT_EQ(odometry->sensorLabel, "odometry");
    EXPECT_EQ(pose->sensorLabel, "localization");
    EXPECT_TRUE(odometry->hasVelocities);
    EXPECT_EQ(odometry->velocityLocal, records[cycle].twist);
    EXPECT_EQ(pose->pose.mean.x(), records[cycle].mapFromRobot.x);
    EXPECT_EQ((odometry->timestamp - mrpt::Clock::fromDouble(SimulationEngine::kEpoch_s)).count(),
              static_cast<long>(cycle) * 1000000);  // 0.1 s in ticks of 100 ns
    EXPECT_EQ(pose->timestamp, odometry->timestamp);
    EXPECT_NEAR(mrpt::Clock::toDouble(scan->timestamp) - SimulationEngine::kEpoch_s,
                0.1 * static_cast<double>(cycle), 2e-6);
  }
}

TEST(RunRawlog, HoldsDepthWithItsCalibration) {
  SimulationSetup setup = hall();
  setup.navigation.depth.enabled = true;
  setup.cameras["front"].columns = 32;
  setup.cameras["front"].rows = 24;
  const LogFile file;
  mrpt::obs::CObservation3DRangeScan::ConstPtr taken;
  {
    RunRawlog log(file.path());
    runSimulation(setup, 1, [&](const SimulationMoment& moment) {
      log.write(moment.frame);
      taken = moment.frame.depth.at(0);
      return false;
    });
  }
  RawlogReader reader(file.path(), 2.0, RawlogFraming::RecordedPoses);
  SensorFrame frame;
  ASSERT_TRUE(reader.next(frame));
  ASSERT_EQ(frame.depth.size(), 1U);
  const auto& read = *frame.depth[0];
  EXPECT_EQ(read.sensorLabel, "front");
  EXPECT_EQ(read.timestamp, taken->timestamp);
  EXPECT_EQ(read.cameraParams.intrinsicParams, taken->cameraParams.intrinsicParams);
  EXPECT_EQ(read.rangeUnits, taken->rangeUnits);
  EXPECT_EQ(read.rangeImage, taken->rangeImage);
  EXPECT_NEAR(read.sensorPose.distanceTo(taken->sensorPose), 0.0, 1e-12);
}

TEST(RunRawlog, NamesAFileThatCannotBeWritten) {
  EXPECT_EQ(test::errorOf([] { RunRawlog log("/no/such/directory/run.rawlog"); }),
            "/no/such/directory/run.rawlog: cannot be written");
}

TEST(RunRawlog, ALogWithoutPosesCannotBeRepeated) {
  RawlogSetup setup;
  setup.rawlog.file = "/usr/share/mrpt/datasets/localization_demo.rawlog";
  setup.rawlog.pose = LogPose::Recorded;
  EXPECT_THAT(test::errorOf([&] { localizeLog(setup, 1); }),
              testing::HasSubstr("expected a CObservationRobotPose a control cycle"));
}

/* Without goals in [scenario] a log is anybody's, with them it is a run to them. */
TEST(RawlogSetupTest, RepeatsARunWhereTheScenarioHasGoals) {
  RawlogSetup setup;
  EXPECT_FALSE(setup.takesRecordedPoses());
  EXPECT_FALSE(setup.repeatsRun());
  EXPECT_EQ(setup.makeMap(), nullptr);
  setup.scenario.goals = {{1, 0, 0}};
  EXPECT_TRUE(setup.takesRecordedPoses());
  EXPECT_TRUE(setup.repeatsRun());
  setup.rawlog.pose = LogPose::Localization;
  EXPECT_FALSE(setup.takesRecordedPoses());
  EXPECT_FALSE(setup.repeatsRun());
}

}  // namespace
}  // namespace bslnav
