#include <mrpt/maps/COccupancyGridMap2D.h>

#include "RawlogRunRig.h"

namespace bslnav {
namespace {

using test::addDrive;
using test::driveInPairs;
using test::evaluate;
using test::Evaluation;
using test::setupOf;
using testing_logs::LogWriter;

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

}  // namespace
}  // namespace bslnav
