#include <bslnav/evaluation/RunSummary.h>
#include <gtest/gtest.h>

namespace bslnav {
namespace {

CycleRecord recordOf(int blindSpots, double total_s = 0.0) {
  CycleRecord record;
  record.blindSpots.resize(static_cast<std::size_t>(blindSpots));
  record.times.total_s = total_s;
  return record;
}

RunSummary finished(const Metrics& metrics) {
  RunSummary summary;
  metrics.finish(summary);
  return summary;
}

TEST(Metrics, AddsUpPathTimeAndStandstill) {
  Metrics metrics;
  // 0.3 m, then nothing, then 0.4 m: 0.7 m in 3 periods of 0.5 s, one of them standing.
  metrics.add(recordOf(0), {0.0, 0.0}, 0.0, 0.5);
  metrics.add(recordOf(0), {0.3, 0.0}, 0.6, 0.5);
  metrics.add(recordOf(0), {0.3, 0.0}, 0.0, 0.5);
  metrics.add(recordOf(0), {0.3, -0.4}, 0.8, 0.5);
  const RunSummary summary = finished(metrics);
  EXPECT_DOUBLE_EQ(summary.pathLength_m, 0.7);
  EXPECT_DOUBLE_EQ(summary.meanSpeed_mps, 0.7 / 1.5);
  EXPECT_DOUBLE_EQ(summary.timeStopped_s, 0.5);
  EXPECT_EQ(summary.cycles, 4);
}

TEST(Metrics, StandsBelowACentimetreASecondAndDrivesBackwardsToo) {
  Metrics metrics;
  for (const double speed_mps : {0.0, 0.009, -0.009, 0.011, -0.011})
    metrics.add(recordOf(0), {}, speed_mps, 1.0);
  EXPECT_DOUBLE_EQ(finished(metrics).timeStopped_s, 2.0);
}

TEST(Metrics, CountsBlindSpotsDroppedBeamsBlockedAndUnhealthyCycles) {
  Metrics metrics;
  CycleRecord blocked = recordOf(4), blind = recordOf(1);
  blocked.motion.blocked = true;
  blocked.droppedBeams = 7;
  blind.health = CycleRecord::Health::NoBeams;
  blind.droppedBeams = 100;
  for (const CycleRecord& record : {blocked, blind, recordOf(2), recordOf(2)})
    metrics.add(record, {}, 0.0, 0.1);
  const RunSummary summary = finished(metrics);
  EXPECT_DOUBLE_EQ(summary.blindSpotsMean, 9.0 / 4.0);
  EXPECT_EQ(summary.blockedCycles, 1);
  EXPECT_EQ(summary.unhealthyCycles, 1);
  EXPECT_EQ(summary.droppedBeams, 107);
}

TEST(Metrics, PercentilesAreThoseOfTheSortedTimes) {
  Metrics metrics;
  for (int i = 200; i >= 1; --i) metrics.add(recordOf(0, 1e-3 * i), {}, 0.0, 0.1);  // 1 to 200 ms
  const Percentiles cycle_ms = finished(metrics).cycle_ms;
  EXPECT_NEAR(cycle_ms.p50, 100.0, 1e-9);  // the smallest that half of them do not exceed
  EXPECT_NEAR(cycle_ms.p99, 198.0, 1e-9);
  EXPECT_NEAR(cycle_ms.max, 200.0, 1e-9);
}

/** Only every sixteenth of 100000 cycles is kept; the longest is known all the same. */
TEST(Metrics, PercentilesOfALongRunAreThoseOfAPartOfIt) {
  Metrics metrics;
  for (int i = 0; i < 100000; ++i)
    metrics.add(recordOf(0, i == 4321 ? 7.0 : 1e-3 * (i % 101)), {}, 0.0, 0.1);
  const Percentiles cycle_ms = finished(metrics).cycle_ms;
  EXPECT_NEAR(cycle_ms.p50, 50.0, 1.0);
  EXPECT_NEAR(cycle_ms.p99, 99.0, 1.0);
  EXPECT_NEAR(cycle_ms.max, 7000.0, 1e-9);
}

TEST(Metrics, StagesHaveTheirOwnPercentiles) {
  Metrics metrics;
  CycleRecord record;
  record.times = {1e-3, 2e-3, 5e-3, 3e-3, 4e-3, 10e-3};
  metrics.add(record, {}, 0.0, 0.1);
  const RunSummary summary = finished(metrics);
  EXPECT_NEAR(summary.blindSpots_ms.p99, 1.0, 1e-9);
  EXPECT_NEAR(summary.costmap_ms.p50, 2.0, 1e-9);
  EXPECT_NEAR(summary.globalPlan_ms.max, 3.0, 1e-9);
  EXPECT_NEAR(summary.people_ms.p50, 5.0, 1e-9);
  EXPECT_NEAR(summary.motion_ms.p50, 4.0, 1e-9);
  EXPECT_NEAR(summary.cycle_ms.p50, 10.0, 1e-9);
}

/** The first cycle is an instant, the second and third last a period each. */
TEST(Metrics, LapsesOfTheGuardAddUp) {
  Metrics metrics;
  CycleRecord record;
  metrics.add(record, {}, 0.1, 0.1);
  record.guard.lapse = GuardRecord::Lapse::Creeping;
  metrics.add(record, {}, 0.1, 0.1);
  record.guard.lapse = GuardRecord::Lapse::Surprised;
  metrics.add(record, {}, 0.1, 0.1);
  EXPECT_NEAR(finished(metrics).lapse_s, 0.2, 1e-9);
}

TEST(Metrics, NothingAddedIsAllZero) {
  const RunSummary summary = finished({});
  EXPECT_EQ(summary.cycles, 0);
  EXPECT_EQ(summary.meanSpeed_mps, 0.0);
  EXPECT_EQ(summary.blindSpotsMean, 0.0);
  EXPECT_EQ(summary.cycle_ms.max, 0.0);
}

TEST(RunSummary, NamesWhatALogHeld) {
  RawlogFindings findings;
  EXPECT_EQ(measurementsOf(findings), "0 scans");
  findings.depthFrames = 1;
  EXPECT_EQ(measurementsOf(findings), "1 depth frame");
  findings.scans = 12;
  EXPECT_EQ(measurementsOf(findings), "12 scans, 1 depth frame");
}

}  // namespace
}  // namespace bslnav
