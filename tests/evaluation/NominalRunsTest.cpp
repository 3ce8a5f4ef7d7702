#include <bslnav/evaluation/NominalRuns.h>

#include "ExperimentRig.h"

namespace bslnav {
namespace {

using test::hallCase;
using test::resultOf;

TEST(NominalRuns, AreTheCasesAsWrittenInTheirOrder) {
  const std::vector<ExperimentCase> cases{hallCase("near", 1), hallCase("far", 2, 2.5)};
  const auto runs = runNominal(cases, 7, 2);
  ASSERT_EQ(runs.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(runs[i].entry.name, cases[i].name);
    EXPECT_EQ(resultOf(runs[i].summary), resultOf(runSimulation(cases[i].setup, 7)));
  }
}

TEST(NominalRuns, TraceHoldsTheWayAndWhenThePersonStarted) {
  const NominalRun run = runNominal({hallCase("hall", 1)}, 1, 1).front();
  const RunTrace& trace = run.trace;
  ASSERT_EQ(trace.positions.size(), static_cast<std::size_t>(run.summary.cycles));
  ASSERT_EQ(trace.speed_mps.size(), trace.positions.size());
  EXPECT_EQ(trace.distance_m.front(), 0.0);
  EXPECT_NEAR(trace.distance_m.back(), run.summary.pathLength_m, 1e-9);
  // The line is at x = 0.5 m: the walk starts in the first cycle with the robot beyond it.
  ASSERT_EQ(trace.walkStarts.size(), 1u);
  const std::size_t start = trace.walkStarts[0].value();
  EXPECT_GE(trace.positions[start].x, 0.5);
  EXPECT_LT(trace.positions[start - 1].x, 0.5);
}

TEST(NominalRuns, TraceKeepsASnapshotForEachInstantThatWasReached) {
  // At most 0.556 m/s over 1.5 m: longer than 2 s, far shorter than 60 s.
  const RunTrace trace = runNominal({hallCase("hall", 1)}, 1, 1).front().trace;
  ASSERT_EQ(trace.snapshots.size(), 2u);
  EXPECT_NEAR(trace.snapshots[0].record.time_s, 1.0, 1e-6);
  EXPECT_NEAR(trace.snapshots[1].record.time_s, 2.0, 1e-6);
  EXPECT_GT(trace.snapshots[1].costs.width(), 0);
  ASSERT_EQ(trace.snapshots[1].people.size(), 1u);
}

}  // namespace
}  // namespace bslnav
