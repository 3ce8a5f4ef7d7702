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
using testing_logs::makeDepth;

/** 2 s along x with 0.5 m/s: scans at 5 Hz where there are any, depth at 10 Hz. */
std::string driveWithDepth(const std::string& name, bool scans) {
  LogWriter log(name);
  for (int i = 0; i <= 20; ++i) {
    log.odometry(0.1 * i, {0.05 * i, 0.0, 0.0});
    if (scans && i % 2 == 0) log.add(twoWalls(0.1 * i));
    log.depth(0.1 * i);
  }
  return log.close();
}

TEST(RawlogRunDepth, LogOfDepthFramesOnlyIsLocalisedAndEvaluatedToItsEnd) {
  const Evaluation run = evaluate(setupOf(driveWithDepth("run_depth_only", false)));
  EXPECT_EQ(run.summary.outcome, Outcome::Goal);
  EXPECT_EQ(run.summary.reason, "");
  EXPECT_EQ(run.summary.cycles, 21);
  EXPECT_EQ(run.summary.rawlog->frames, 21);
  EXPECT_EQ(run.summary.rawlog->scans, 0);
  EXPECT_EQ(run.summary.rawlog->depthFrames, 21);
  EXPECT_EQ(measurementsOf(*run.summary.rawlog), "21 depth frames");
  EXPECT_EQ(run.summary.rawlog->unusableBeams_percent, 0.0);
  EXPECT_NEAR(run.summary.pathLength_m, 1.0, 1e-6);
  EXPECT_NEAR(run.records[10].mapFromRobot.x, 0.5, 1e-6);
}

TEST(RawlogRunDepth, ScansAndDepthOfDifferentRatesAreEvaluatedTogether) {
  const Evaluation run = evaluate(setupOf(driveWithDepth("run_mixed", true)));
  EXPECT_EQ(run.summary.outcome, Outcome::Goal);
  EXPECT_EQ(run.summary.cycles, 32);
  EXPECT_EQ(measurementsOf(*run.summary.rawlog), "11 scans, 21 depth frames");
  EXPECT_TRUE(run.summary.rawlog->clockJumpsAtRecords.empty());
  EXPECT_NEAR(run.summary.pathLength_m, 1.0, 1e-6);
}

TEST(RawlogRunDepth, MapOfTheLogIsThatOfItsScans) {
  RawlogSetup both = setupOf(driveWithDepth("run_map_mixed", true));
  LogWriter log("run_map_scans");
  RawlogSetup scans = setupOf(addDrive(log, 2.0).close());
  both.rawlog.map = scans.rawlog.map = "log";
  const auto map = localizeLog(both, 1).map, expected = localizeLog(scans, 1).map;
  ASSERT_EQ(map->getSizeX(), expected->getSizeX());
  EXPECT_EQ(map->getRawMap(), expected->getRawMap());
}

TEST(RawlogRunDepth, NoMapComesFromALogWithoutScans) {
  RawlogSetup setup = setupOf(driveWithDepth("run_map_depth", false));
  setup.rawlog.map = "log";
  EXPECT_THAT(errorOf([&] { localizeLog(setup, 1); }),
              AllOf(HasSubstr(setup.rawlog.file), HasSubstr("no 2D laser scan to build a map")));
}

TEST(RawlogRunDepth, ParticleFilterFollowsTheOdometryWithoutScans) {
  mrpt::maps::COccupancyGridMap2D map(-3.0f, 6.0f, -3.0f, 3.0f, 0.05f);
  map.fill(0.9f);
  const std::string file = testing::TempDir() + "bslnav_depth_only.gridmap";
  mrpt::io::CFileGZOutputStream stream(file);
  mrpt::serialization::archiveFrom(stream) << map;
  stream.close();
  RawlogSetup setup = setupOf(driveWithDepth("run_depth_filter", false));
  setup.rawlog.map = file;
  setup.localization.source = PoseSource::ParticleFilter;
  const LocalizedLog log = localizeLog(setup, 1);
  const auto &first = log.path.samples().front(), &last = log.path.samples().back();
  // The mean of 500 particles within ±0.3 m, with 1 cm of noise a frame: 8 mm where it starts, 2 mm
  // more after 20 frames.
  EXPECT_NEAR(last.pose.x - first.pose.x, 1.0, 0.03);
  EXPECT_NEAR(last.pose.y, 0.0, 0.05);
  EXPECT_GT(last.spread_m, first.spread_m);
  EXPECT_EQ(log.path.samples().size(), 21u);
}

TEST(RawlogRunDepth, DroppedDepthFramesAreReported) {
  LogWriter log("run_depth_dropped");
  addDrive(log, 2.0);  // records 0 to 21
  auto empty = makeDepth(2.1);
  empty.hasRangeImage = false;
  const Evaluation run = evaluate(setupOf(log.add(empty).add(empty).close()));
  EXPECT_EQ(run.summary.rawlog->droppedDepthFrames, 2);
  EXPECT_EQ(measurementsOf(*run.summary.rawlog), "11 scans");
  EXPECT_THAT(run.summary.reason, HasSubstr("2 depth frames dropped, the first: record 22: "));
}

TEST(RawlogRunDepth, TruncatedLogWithDepthIsEvaluatedUpToThereWithAWarning) {
  const std::string file = driveWithDepth("run_depth_cut", true);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) * 3 / 4);
  const Evaluation run = evaluate(setupOf(file));
  EXPECT_THAT(run.summary.reason, HasSubstr("truncated: evaluated up to record "));
  EXPECT_GT(run.records.size(), 10u);
  EXPECT_LT(run.records.size(), 32u);
}

TEST(RawlogRunDepth, OneDepthFrameIsALog) {
  const std::string file = BSLNAV_SHARED_DATA "/depth/five_people_depth.rawlog";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  const Evaluation run = evaluate(setupOf(file));
  EXPECT_EQ(run.summary.outcome, Outcome::Goal);
  EXPECT_EQ(run.summary.cycles, 1);
  EXPECT_EQ(run.summary.rawlog->depthFrames, 1);
  EXPECT_EQ(run.summary.duration_s, 0.0);
}

}  // namespace
}  // namespace bslnav
