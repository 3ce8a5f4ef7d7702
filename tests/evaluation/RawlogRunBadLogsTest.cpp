#include <mrpt/maps/COccupancyGridMap2D.h>

#include <filesystem>

#include "RawlogRunRig.h"

namespace bslnav {
namespace {

using test::addDrive;
using test::errorOf;
using test::evaluate;
using test::Evaluation;
using test::setupOf;
using test::twoWalls;
using testing::HasSubstr;
using testing_logs::LogWriter;

TEST(RawlogRun, TruncatedLogIsEvaluatedUpToThereWithAWarning) {
  LogWriter log("run_truncated", 0);
  const std::string file = addDrive(log, 4.0).close();
  std::filesystem::resize_file(file, std::filesystem::file_size(file) * 3 / 4);
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
  for (const double range_m : {std::nan(""), std::numeric_limits<double>::infinity(), 0.0, -1.0}) {
    const auto map = mapOf("run_bad_ranges", static_cast<float>(range_m), true);
    ASSERT_EQ(map->getSizeX(), expected->getSizeX()) << range_m;
    ASSERT_EQ(map->getSizeY(), expected->getSizeY()) << range_m;
    ASSERT_EQ(map->getRawMap(), expected->getRawMap()) << range_m;
  }
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
