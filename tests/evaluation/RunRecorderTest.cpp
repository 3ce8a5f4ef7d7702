#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "RunRecorderFixture.h"

namespace bslnav {
namespace {

using test::linesOf;
using test::RunRecorderTest;
using test::textOf;

/** Records with every health, motion mode, path status, and with and without candidates. */
std::vector<CycleRecord> allKindsOfRecords() {
  std::vector<CycleRecord> records;
  for (int health = 0; health < 4; ++health)
    for (int mode = 0; mode < 7; ++mode)
      for (int status = 0; status < 6; ++status)
        for (const int best : {-2, -1, 0}) {  // -2: nothing was planned
          CycleRecord r;
          r.index = static_cast<int>(records.size());
          r.health = static_cast<CycleRecord::Health>(health);
          r.motion.mode = static_cast<MotionMode>(mode);
          r.pathStatus = static_cast<PathResult::Status>(status);
          r.motion.blocked = best == -1;
          r.motion.planned = best > -2;
          r.dwa.best = best;
          r.dwa.candidates.resize(3);
          r.twist.vx = health == 3 ? std::nan("") : 0.1;
          records.push_back(r);
        }
  return records;
}

TEST_F(RunRecorderTest, CyclesHaveOneRowEachWithTheSameColumns) {
  RunRecorder recorder(directory, config);
  const auto records = allKindsOfRecords();
  for (const CycleRecord& record : records) recorder.write(record, {});
  recorder.finish({});
  const auto lines = linesOf(directory + "/cycles.csv");
  ASSERT_EQ(lines.size(), records.size() + 1);
  const auto commas = std::count(lines[0].begin(), lines[0].end(), ',');
  for (const auto& line : lines)
    ASSERT_EQ(std::count(line.begin(), line.end(), ','), commas) << line;
}

TEST_F(RunRecorderTest, CycleRowHasTheCertificateOfTheGuard) {
  CycleRecord record;
  record.guard.active = true;
  record.guard.bound_mps = 0.42;
  record.guard.slack_m = 10.0;
  RunRecorder recorder(directory, config);
  recorder.write(record, {});
  record.guard.slack_m = -0.03;
  record.guard.reachAtStop_m = 0.5;
  record.guard.impact_mps = 0.04;
  record.guard.binding = FrontierPoint{1.5f, -2.25f, FrontierPoint::Kind::Seen};
  record.guard.hidden = 7;
  record.guard.seen = 9;
  record.guard.lapse = GuardRecord::Lapse::Creeping;
  recorder.write(record, {});
  recorder.finish({});
  const auto lines = linesOf(directory + "/cycles.csv");
  EXPECT_THAT(lines[1], testing::EndsWith(",0.420,10.000,0.000,0.000,,,,0,0,"));
  EXPECT_THAT(lines[2],
              testing::EndsWith(",0.420,-0.030,0.500,0.040,seen,1.500,-2.250,7,9,creeping"));
}

TEST_F(RunRecorderTest, CycleRowTellsPoseVelocityCommandAndReason) {
  CycleRecord record;
  record.index = 3;
  record.time_s = 0.3;
  record.mapFromRobot = {1.0, -2.0, 0.5};
  record.twist = {0.25, 0.0625, -0.125};
  record.motion.command = {0.3, -0.25, 0.1};
  record.motion.mode = MotionMode::Follow;
  record.motion.blocked = true;
  record.beams = 683;
  record.droppedBeams = 5;
  record.blindSpots.resize(2);
  record.replanned = true;
  record.path.resize(40);
  RunRecorder recorder(directory, config);
  recorder.write(record, {1.5, -2.5, 0.75});
  recorder.finish({});
  EXPECT_EQ(linesOf(directory + "/cycles.csv")[1],
            "3,0.300,1.0000,-2.0000,0.50000,1.5000,-2.5000,0.75000,0.2500,-0.12500,0.3000,0.10000,"
            "follow,ok,no admissible velocity,683,5,2,1,40,,,,,,,,,0.0625,-0.2500,,,,,,,,,,");
}

TEST_F(RunRecorderTest, CandidatesHaveOneRowEach) {
  RunRecorder recorder(directory, config);
  recorder.recordCandidates();
  CycleRecord record;
  record.dwa.candidates.resize(5);
  record.dwa.candidates[1].v_mps = 0.5;
  record.dwa.candidates[1].vy_mps = -0.125;
  record.dwa.candidates[1].verdict = Candidate::Verdict::Obstacle;
  recorder.write(record, {});  // not planned in this cycle: the candidates are old ones
  record.index = 1;
  record.motion.planned = true;
  recorder.write(record, {});
  recorder.finish({});
  const auto lines = linesOf(directory + "/candidates.csv");
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines[2], "1,0.5000,0.00000,obstacle,0.0000,0.0000,0.0000,0.0000,0.0000,-0.1250");
}

TEST_F(RunRecorderTest, ConfigurationCanBeLoadedAgainAndSaysTheSame) {
  config.load({BSLNAV_SOURCE_DIR "/config/scenarios/s1.ini"}, {"dwa.horizon_s=3.25"});
  const RunRecorder recorder(directory, config);
  SimulationSetup again;
  Config loaded;
  again.bind(loaded);
  loaded.load({recorder.path("config.ini")});
  EXPECT_EQ(again.navigation.dwa.horizon_s, 3.25);
  EXPECT_EQ(again.world.walls.size(), setup.world.walls.size());
  std::ostringstream text;
  loaded.print(text);
  EXPECT_EQ(text.str().size(), textOf(recorder.path("config.ini")).size());
}

TEST_F(RunRecorderTest, SummaryHasTheKeysOfTheDesign) {
  RunSummary summary;
  summary.outcome = Outcome::Contact;
  summary.contact = summary.atFault = true;
  summary.impactSpeed_mps = 0.4;
  summary.seed = 18446744073709551615ULL;
  summary.cycle_ms = {1.0, 2.0, 3.0};
  RunRecorder(directory, config).finish(summary);
  const auto json = nlohmann::json::parse(textOf(directory + "/summary.json"));
  for (const char* key : {"outcome", "time_to_goal_s", "path_length_m", "mean_speed_mps", "contact",
                          "at_fault", "impact_speed_mps", "min_clearance_m", "time_stopped_s",
                          "blind_spots_mean", "cycle_ms", "seed", "method", "version"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["outcome"], "contact");
  EXPECT_TRUE(json["time_to_goal_s"].is_null());
  EXPECT_EQ(json["impact_speed_mps"], 0.4);
  EXPECT_EQ(json["cycle_ms"], (nlohmann::json{{"p50", 1.0}, {"p99", 2.0}, {"max", 3.0}}));
  EXPECT_EQ(json["seed"], 18446744073709551615ULL);
  EXPECT_FALSE(json.contains("rawlog"));
}

TEST_F(RunRecorderTest, SummaryOfALogTellsAboutTheLog) {
  RunSummary summary;
  summary.rawlog.emplace();
  summary.rawlog->truncatedAtRecord = 12;
  summary.rawlog->frames = 42;
  summary.rawlog->scans = 37;
  summary.rawlog->depthFrames = 7;
  summary.rawlog->droppedDepthFrames = 2;
  summary.rawlog->clockJumpsAtRecords = {3, 5};
  summary.rawlog->recorded_s = 50.0;
  summary.rawlog->wall_s = 2.0;
  RunRecorder(directory, config).finish(summary);
  const auto json = nlohmann::json::parse(textOf(directory + "/summary.json"))["rawlog"];
  EXPECT_EQ(json["truncated_at_record"], 12);
  EXPECT_EQ(json["frames"], 42);
  EXPECT_EQ(json["scans"], 37);
  EXPECT_EQ(json["depth_frames"], 7);
  EXPECT_EQ(json["dropped_depth_frames"], 2);
  EXPECT_EQ(json["clock_jumps_at_records"], (std::vector<int>{3, 5}));
  EXPECT_EQ(json["times_faster_than_recording"], 25.0);
}

TEST_F(RunRecorderTest, NamesThatAreNotUtf8DoNotBreakTheSummary) {
  RunSummary summary;
  summary.methodName = "caf\xE9";  // Latin-1
  RunRecorder(directory, config).finish(summary);
  EXPECT_EQ(nlohmann::json::parse(textOf(directory + "/summary.json"))["method_name"], "caf\uFFFD");
}

}  // namespace
}  // namespace bslnav
