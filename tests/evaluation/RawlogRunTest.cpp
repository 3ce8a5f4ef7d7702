#include <bslnav/evaluation/RawlogRun.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <filesystem>

#include "../navigation/RawlogReaderLogs.h"
#include "EvaluationRig.h"

namespace bslnav {
namespace {

namespace fs = std::filesystem;
using mrpt::math::TPose2D;
using test::errorOf;
using testing::HasSubstr;
using testing_logs::LogWriter;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/** 181 beams over 180° to 8 m: a wall at y = 2.025 m on the left, 4 m on the right; one jump ahead.
 */
mrpt::obs::CObservation2DRangeScan twoWalls(double time_s) {
  auto scan = testing_logs::makeScan(time_s);
  scan.aperture = static_cast<float>(M_PI);
  scan.maxRange = 8.0f;
  scan.resizeScanAndAssign(181, 4.0f, true);
  for (int i = 90; i < 181; ++i) {
    const double range_m = 2.025 / std::sin((i - 90) * M_PI / 180.0);
    scan.setScanRange(static_cast<std::size_t>(i), static_cast<float>(std::min(8.0, range_m)));
  }
  return scan;
}

/** A robot that drives along x with 0.5 m/s for `seconds`, at 5 Hz, as single observations. */
LogWriter& addDrive(LogWriter& log, double seconds, double from_s = 0.0, double from_m = 0.0) {
  for (int i = 0; 0.2 * i <= seconds + 1e-9; ++i) {
    log.odometry(from_s + 0.2 * i, {from_m + 0.1 * i, 0.0, 0.0});
    log.add(twoWalls(from_s + 0.2 * i));
  }
  return log;
}

/** The same as pairs of actions and sensory frames. */
std::string driveInPairs(const std::string& name, double seconds) {
  LogWriter log(name);
  for (int i = 0; 0.2 * i <= seconds + 1e-9; ++i) {
    log.action({i == 0 ? 0.0 : 0.1, 0.0, 0.0}, mrpt::math::TTwist2D{0.5, 0.0, 0.0});
    mrpt::obs::CSensoryFrame frame;
    frame.insert(std::make_shared<mrpt::obs::CObservation2DRangeScan>(twoWalls(0.2 * i)));
    log.add(frame);
  }
  return log.close();
}

RawlogSetup setupOf(const std::string& file) {
  RawlogSetup setup;
  setup.rawlog.file = file;
  setup.navigation.blindSpots.source = BlindSpotSource::ScanJumps;
  setup.navigation.limits.maxSpeed_mps = 1.0;
  setup.navigation.dwa.weights.velocity = 0.0;
  return setup;
}

/** Both passes, and what the observer saw. */
struct Evaluation {
  RunSummary summary;
  LocalizedLog log;
  std::vector<CycleRecord> records;
};

Evaluation evaluate(const RawlogSetup& setup) {
  LocalizedLog log = localizeLog(setup, 1);
  std::vector<CycleRecord> records;
  RunSummary summary = evaluateLog(setup, log, 1, [&](const RawlogMoment& moment) {
    records.push_back(moment.record);
    return true;
  });
  return {std::move(summary), std::move(log), std::move(records)};
}

TEST(RawlogRun, EvaluatesSingleObservations) {
  LogWriter log("run_observations");
  const Evaluation run = evaluate(setupOf(addDrive(log, 4.0).close()));
  EXPECT_EQ(run.summary.outcome, Outcome::Goal);
  EXPECT_EQ(run.summary.reason, "");
  ASSERT_TRUE(run.summary.rawlog.has_value());
  EXPECT_EQ(run.summary.rawlog->records, 42);
  EXPECT_EQ(run.summary.rawlog->frames, 21);
  EXPECT_EQ(run.summary.cycles, 21);
  EXPECT_NEAR(run.summary.duration_s, 4.0, 1e-6);
  EXPECT_NEAR(run.summary.pathLength_m, 2.0, 1e-6);  // 20 steps of 0.1 m
  EXPECT_NEAR(run.summary.meanSpeed_mps, 0.5, 1e-6);
  EXPECT_NEAR(run.summary.blindSpotsMean, 1.0, 1e-9);  // the jump straight ahead
  EXPECT_NEAR(run.records[10].mapFromRobot.x, 1.0, 1e-6);
}

TEST(RawlogRun, EvaluatesActionsAndSensoryFramesAlike) {
  LogWriter log("run_alike");
  const Evaluation single = evaluate(setupOf(addDrive(log, 4.0).close()));
  const Evaluation pairs = evaluate(setupOf(driveInPairs("run_pairs", 4.0)));
  EXPECT_EQ(pairs.summary.outcome, Outcome::Goal);
  ASSERT_EQ(pairs.records.size(), single.records.size());
  for (std::size_t i = 1; i < pairs.records.size(); ++i) {
    EXPECT_NEAR(pairs.records[i].mapFromRobot.x, single.records[i].mapFromRobot.x, 1e-5);
    EXPECT_NEAR(pairs.records[i].twist.vx, 0.5, 1e-5);
    EXPECT_EQ(pairs.records[i].blindSpots.size(), 1u);
  }
}

TEST(RawlogRun, TakesTheGoalFromTheRecordedFuture) {
  LogWriter log("run_future");
  RawlogSetup setup = setupOf(addDrive(log, 4.0).close());
  setup.rawlog.goalAhead_s = 2.0;  // 1 m ahead
  const Evaluation run = evaluate(setup);
  EXPECT_NEAR(run.records[5].path.back().x, 0.5 + 1.0, 1e-6);
  EXPECT_NEAR(run.records[18].path.back().x, 2.0, 1e-6);  // the log ends there
}

TEST(RawlogRun, ComparesThePlannersChoiceWithTheRecording) {
  LogWriter log("run_comparison");
  const Evaluation run = evaluate(setupOf(addDrive(log, 4.0).close()));
  double speed = 0.0, yawRate = 0.0, slower = 0.0;
  for (const CycleRecord& record : run.records) {
    const auto chosen = chosenVelocity(record);
    speed += std::abs(chosen.vx - record.twist.vx) / 21.0;
    yawRate += std::abs(chosen.omega - record.twist.omega) / 21.0;
    slower += (record.twist.vx - chosen.vx >= 0.1) * 100.0 / 21.0;
  }
  EXPECT_GT(speed, 0.0);
  EXPECT_NEAR(run.summary.rawlog->speedDifferenceMean_mps, speed, 1e-9);
  EXPECT_NEAR(run.summary.rawlog->yawRateDifferenceMean_radps, yawRate, 1e-9);
  EXPECT_NEAR(run.summary.rawlog->slowerThanRecorded_percent, slower, 1e-9);
}

TEST(RawlogRun, ChosenVelocityIsTheBestCandidateOrElseTheCommand) {
  CycleRecord record;
  record.motion.command = {0.1, 0.0, 0.2};
  record.dwa.candidates.resize(2);
  record.dwa.candidates[1].v_mps = 0.7;
  record.dwa.candidates[1].w_radps = -0.3;
  record.dwa.best = 1;
  EXPECT_EQ(chosenVelocity(record).vx, 0.1);  // nothing was planned in this cycle
  record.motion.planned = true;
  EXPECT_EQ(chosenVelocity(record).vx, 0.7);
  EXPECT_EQ(chosenVelocity(record).omega, -0.3);
  record.dwa.best = -1;
  EXPECT_EQ(chosenVelocity(record).vx, 0.1);
}

TEST(RawlogRun, TruncatedLogIsEvaluatedUpToThereWithAWarning) {
  LogWriter log("run_truncated", 0);
  const std::string file = addDrive(log, 4.0).close();
  fs::resize_file(file, fs::file_size(file) * 3 / 4);
  const Evaluation run = evaluate(setupOf(file));
  EXPECT_EQ(run.summary.outcome, Outcome::Goal);
  ASSERT_TRUE(run.summary.rawlog->truncatedAtRecord.has_value());
  EXPECT_THAT(run.summary.reason,
              HasSubstr("truncated: evaluated up to record " +
                        std::to_string(*run.summary.rawlog->truncatedAtRecord)));
  EXPECT_GT(run.records.size(), 10u);
  EXPECT_LT(run.records.size(), 21u);
}

TEST(RawlogRun, DoesNotIntegrateOverAClockGap) {
  LogWriter log("run_gap");
  addDrive(log, 2.0);  // to x = 1 m; then a minute and 50 m of odometry are missing
  const std::string file = addDrive(log, 2.0, 62.0, 51.0).close();
  const Evaluation run = evaluate(setupOf(file));
  EXPECT_THAT(run.summary.reason, HasSubstr("clock jump"));
  ASSERT_EQ(run.summary.rawlog->clockJumpsAtRecords.size(), 1u);
  EXPECT_EQ(run.summary.cycles, 22);
  EXPECT_NEAR(run.records.back().mapFromRobot.x, 2.0, 1e-6);
  EXPECT_NEAR(run.summary.pathLength_m, 2.0, 1e-6);
  EXPECT_NEAR(run.summary.meanSpeed_mps, 0.5, 1e-6);  // the minute does not count
}

TEST(RawlogRun, WithoutOdometryTheRobotSeemsToStandAndTheReportSaysSo) {
  LogWriter log("run_scans_only");
  for (int i = 0; i < 10; ++i) log.add(twoWalls(0.1 * i));
  const Evaluation run = evaluate(setupOf(log.close()));
  EXPECT_FALSE(run.summary.rawlog->hasOdometry);
  EXPECT_THAT(run.summary.reason, HasSubstr("no odometry"));
  EXPECT_EQ(run.summary.pathLength_m, 0.0);
  EXPECT_EQ(run.records.size(), 10u);
  EXPECT_EQ(run.records[3].blindSpots.size(), 1u);
}

TEST(RawlogRun, MapOfTheLogHoldsWhatItsScansSaw) {
  LogWriter log("run_map_of_log");
  RawlogSetup setup = setupOf(addDrive(log, 2.0).close());
  setup.rawlog.map = "log";
  const LocalizedLog localized = localizeLog(setup, 1);
  ASSERT_TRUE(localized.map);
  EXPECT_LT(localized.map->getPos(0.525f, 2.025f), 0.4f);           // the wall
  EXPECT_GT(localized.map->getPos(0.525f, 0.525f), 0.6f);           // driven past
  EXPECT_NEAR(localized.map->getPos(0.525f, 2.525f), 0.5f, 0.05f);  // behind the wall
  EXPECT_EQ(evaluateLog(setup, localized, 1).outcome, Outcome::Goal);
}

TEST(RawlogRun, MapOfTheLogIgnoresRangesThatAreNotNumbers) {
  const auto mapOf = [](const std::string& name, float range_m, bool valid) {
    LogWriter log(name);
    addDrive(log, 1.0);
    auto scan = twoWalls(1.2);
    for (std::size_t i = 0; i < 181; i += 2) {
      scan.setScanRange(i, range_m);
      scan.setScanRangeValidity(i, valid);
    }
    RawlogSetup setup = setupOf(log.odometry(1.2, {0.6, 0.0, 0.0}).add(scan).close());
    setup.rawlog.map = "log";
    return localizeLog(setup, 1).map;
  };
  const auto expected = mapOf("run_invalid_ranges", 0.0f, false);
  for (const double range_m : {kNaN, std::numeric_limits<double>::infinity(), 0.0, -1.0}) {
    const auto map = mapOf("run_bad_ranges", static_cast<float>(range_m), true);
    ASSERT_EQ(map->getSizeX(), expected->getSizeX()) << range_m;
    ASSERT_EQ(map->getSizeY(), expected->getSizeY()) << range_m;
    ASSERT_EQ(map->getRawMap(), expected->getRawMap()) << range_m;
  }
}

TEST(RawlogRun, UsesAMapFile) {
  mrpt::maps::COccupancyGridMap2D map(-3.0f, 6.0f, -3.0f, 3.0f, 0.05f);
  map.fill(0.9f);
  const std::string file = testing::TempDir() + "bslnav_evaluation.gridmap";
  mrpt::io::CFileGZOutputStream stream(file);
  mrpt::serialization::archiveFrom(stream) << map;
  stream.close();
  LogWriter log("run_map_file");
  RawlogSetup setup = setupOf(addDrive(log, 1.0).close());
  setup.rawlog.map = file;
  setup.rawlog.initialPose = {0.5, 0.0, 0.0};
  const Evaluation run = evaluate(setup);
  ASSERT_TRUE(run.log.map);
  EXPECT_NEAR(run.log.map->getXMax(), 6.0, 0.05);
  EXPECT_NEAR(run.records[0].mapFromRobot.x, 0.5, 1e-9);
}

TEST(RawlogRun, IsTheSameInEveryRepetition) {
  LogWriter log("run_repetition");
  const RawlogSetup setup = setupOf(addDrive(log, 2.0).close());
  const Evaluation a = evaluate(setup), b = evaluate(setup);
  EXPECT_EQ(test::resultOf(a.summary), test::resultOf(b.summary));
  for (std::size_t i = 0; i < a.records.size(); ++i)
    ASSERT_EQ(a.records[i].motion.command, b.records[i].motion.command);
}

TEST(RawlogRun, StopsWhenTheObserverSaysSo) {
  LogWriter log("run_interrupted");
  const RawlogSetup setup = setupOf(addDrive(log, 4.0).close());
  double progress = 0.0;
  const RunSummary summary =
      evaluateLog(setup, localizeLog(setup, 1), 1, [&](const RawlogMoment& moment) {
        progress = moment.progress;
        return moment.record.index < 10;
      });
  EXPECT_EQ(summary.outcome, Outcome::Error);
  EXPECT_EQ(summary.reason, "interrupted");
  EXPECT_EQ(summary.cycles, 11);
  EXPECT_NEAR(progress, 0.5, 1e-6);
  EXPECT_NEAR(summary.duration_s, 2.0, 1e-6);
}

TEST(RawlogRun, RefusesWhatIsNoLogNamingTheFile) {
  const std::string text = testing::TempDir() + "bslnav_run_text.rawlog", empty = text + ".empty";
  std::ofstream(text) << "this is a text, and not a rawlog at all\n";
  std::ofstream(empty).flush();
  LogWriter blind("run_odometry_only");
  blind.odometry(0.0, {}).odometry(0.1, {});
  for (const std::string& file :
       {text, empty, blind.close(), testing::TempDir() + "bslnav_no_such_log.rawlog"})
    EXPECT_THAT(errorOf([&] { localizeLog(setupOf(file), 1); }), HasSubstr(file));
}

TEST(RawlogRun, LogWithoutScansIsAFailedRunAndAMissingOneAConfigurationError) {
  LogWriter blind("run_no_scans");
  const std::string file = blind.odometry(0.0, {}).close();
  const auto exitCodeOf = [](const std::string& log) {
    try {
      localizeLog(setupOf(log), 1);
    } catch (const Error& error) {
      return error.exitCode();
    }
    return 0;
  };
  EXPECT_EQ(exitCodeOf(file), 1);
  EXPECT_EQ(exitCodeOf(testing::TempDir() + "bslnav_no_such_log.rawlog"), 2);
}

TEST(RawlogSetup, RefusesTheTruthAndAParticleFilterWithoutAMapFile) {
  RawlogSetup setup = setupOf("some.rawlog");
  setup.localization.source = PoseSource::Truth;
  EXPECT_THAT(errorOf([&] { setup.check(); }), HasSubstr("[localization] source"));
  setup.localization.source = PoseSource::ParticleFilter;
  for (const char* map : {"none", "log"}) {
    setup.rawlog.map = map;
    EXPECT_THAT(errorOf([&] { setup.check(); }), HasSubstr("[rawlog] map"));
  }
  setup.rawlog.map = "hall.gridmap";
  EXPECT_EQ(errorOf([&] { setup.check(); }), "");
  setup.rawlog.file.clear();
  EXPECT_THAT(errorOf([&] { setup.check(); }), HasSubstr("[rawlog] file"));
}

}  // namespace
}  // namespace bslnav
