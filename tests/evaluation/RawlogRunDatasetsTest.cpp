#include <bslnav/evaluation/RawlogRun.h>

#include <filesystem>

#include "EvaluationRig.h"

namespace bslnav {
namespace {

/** The evaluation of a log as its configuration files say; skips without the data. */
class RawlogRunDatasets : public testing::Test {
 protected:
  void load(const std::vector<std::string>& files, const std::string& log = "") {
    Config config;
    setup.bind(config);
    std::vector<std::string> paths;
    for (const auto& file : files) paths.push_back(BSLNAV_SOURCE_DIR "/config/" + file);
    config.load(paths);
    if (!log.empty()) setup.rawlog.file = log;
  }
  bool isHere() const { return std::filesystem::exists(setup.rawlog.file); }

  RawlogSetup setup;
};

TEST_F(RawlogRunDatasets, LocalizationDemoStaysLocalisedInItsMap) {
  load({"rawlog.ini", "rawlog-localization-demo.ini"});
  if (!isHere()) GTEST_SKIP() << setup.rawlog.file << " is not here";
  const LocalizedLog log = localizeLog(setup, 1);
  EXPECT_GT(log.findings.meanSpread_m, 0.0);
  EXPECT_LT(log.findings.meanSpread_m, 0.2);
  EXPECT_NEAR(log.findings.recordedPath_m, 12.8, 1.5);  // of the odometry: 12.8 m
  const RunSummary summary = evaluateLog(setup, log, 1);
  EXPECT_EQ(summary.outcome, Outcome::Goal);
  EXPECT_EQ(summary.reason, "");
  EXPECT_EQ(summary.cycles, 37);
  EXPECT_EQ(summary.unhealthyCycles, 0);
  EXPECT_GT(summary.blindSpotsMean, 1.0);
  RecordProperty("times_faster_than_recording",
                 std::to_string(log.findings.recorded_s / summary.rawlog->wall_s));
}

TEST_F(RawlogRunDatasets, TelecomFacultyIsEvaluatedToItsEndByOdometry) {
  load({"rawlog.ini"},
       "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog");
  if (!isHere()) GTEST_SKIP() << setup.rawlog.file << " is not here";
  const LocalizedLog log = localizeLog(setup, 1);
  const RunSummary summary = evaluateLog(setup, log, 1);
  EXPECT_EQ(summary.outcome, Outcome::Goal);
  EXPECT_EQ(summary.cycles, 225);
  EXPECT_NEAR(summary.duration_s, 59.1, 0.5);
  EXPECT_NEAR(summary.pathLength_m, 76.4, 0.5);
  EXPECT_LT(summary.blockedCycles, 113);  // half of them
  EXPECT_EQ(summary.rawlog->clockJumpsAtRecords.size(), 0u);
  RecordProperty("times_faster_than_recording",
                 std::to_string(log.findings.recorded_s / summary.rawlog->wall_s));
}

}  // namespace
}  // namespace bslnav
