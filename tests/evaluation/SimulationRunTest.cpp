#include <future>

#include "EvaluationRig.h"

namespace bslnav {
namespace {

using test::hall;
using test::resultOf;
using test::s1;
using testing::HasSubstr;

TEST(SimulationRunS1, Method1RunsIntoThePerson) {
  const RunSummary summary = runSimulation(s1(1), 1);
  EXPECT_EQ(summary.outcome, Outcome::Contact) << summary.reason;
  EXPECT_EQ(summary.reason, "contact with a person");
  EXPECT_TRUE(summary.contact);
  EXPECT_FALSE(summary.timeToGoal_s.has_value());
  ASSERT_TRUE(summary.impactSpeed_mps.has_value());
  EXPECT_EQ(summary.atFault, *summary.impactSpeed_mps > 0.05);
  EXPECT_LE(summary.minClearance_m.value(), 0.0);
  EXPECT_GT(*summary.minClearance_m,
            -0.2);  // at most a period at 1.7 m/s: what came later does not count
  EXPECT_EQ(summary.blindSpotsMean, 0.0);
}

TEST(SimulationRunS1, Method2ArrivesWithoutContact) {
  const RunSummary summary = runSimulation(s1(2), 1);
  EXPECT_EQ(summary.outcome, Outcome::Goal) << summary.reason;
  EXPECT_FALSE(summary.contact);
  EXPECT_FALSE(summary.impactSpeed_mps.has_value());
  EXPECT_GT(summary.minClearance_m.value(), 0.0);
  EXPECT_GT(summary.blindSpotsMean, 0.5);
  // 9.5 m straight on less 0.1 m of tolerance; at 0.556 m/s that takes 17 s and more.
  EXPECT_GE(summary.pathLength_m, 9.4);
  EXPECT_GT(summary.timeToGoal_s.value(), 17.0);
  EXPECT_EQ(*summary.timeToGoal_s, summary.duration_s);
  EXPECT_EQ(summary.cycles, std::lround(summary.duration_s / 0.1) + 1);  // the first at time 0
  EXPECT_NEAR(summary.meanSpeed_mps, summary.pathLength_m / summary.duration_s, 1e-9);
}

TEST(SimulationRunS1, SameSeedSameRunAndOtherSeedsOtherNoise) {
  const SimulationSetup setup = s1(2);
  const std::string first = resultOf(runSimulation(setup, 5));
  EXPECT_EQ(resultOf(runSimulation(setup, 5)), first);
  EXPECT_NE(resultOf(runSimulation(setup, 6)), first);
}

TEST(SimulationRunS1, RunsInTwoThreadsAreEqualToSingleOnes) {
  const SimulationSetup method1 = s1(1), method2 = s1(2);
  const std::string single[] = {resultOf(runSimulation(method1, 3)),
                                resultOf(runSimulation(method2, 4))};
  auto other = std::async(std::launch::async, [&] { return resultOf(runSimulation(method1, 3)); });
  EXPECT_EQ(resultOf(runSimulation(method2, 4)), single[1]);
  EXPECT_EQ(other.get(), single[0]);
}

TEST(SimulationRunS1, ParticleFilterLocalisesAndArrives) {
  double worst_m = 0.0;
  const SimulationSetup setup = s1(2, {"localization.source=particle_filter"});
  const RunSummary summary = runSimulation(setup, 1, [&](const SimulationMoment& m) {
    const auto& estimate = m.record.mapFromRobot;
    worst_m =
        std::max(worst_m, std::hypot(estimate.x - m.truth.pose.x, estimate.y - m.truth.pose.y));
    return true;
  });
  EXPECT_EQ(summary.outcome, Outcome::Goal) << summary.reason;
  EXPECT_LT(worst_m, 0.3);
  EXPECT_GT(worst_m, 1e-4);  // it is an estimate
}

TEST(SimulationRun, OdometryDriftsButArrives) {
  SimulationSetup setup = hall(7.0);
  setup.localization.source = PoseSource::Odometry;
  mrpt::math::TPose2D believed, truth;
  const RunSummary summary = runSimulation(setup, 2, [&](const SimulationMoment& m) {
    believed = m.record.mapFromRobot;
    truth = m.truth.pose;
    return true;
  });
  EXPECT_EQ(summary.outcome, Outcome::Goal) << summary.reason;
  EXPECT_LT(std::hypot(believed.x - 7.0, believed.y), 0.1);
  // Heading error after 7 m: 0.5°·√7 = 1.3°; across, ∫ of it: 0.0087·√(7³/3) = 0.09 m (1 σ).
  const double drift_m = std::hypot(believed.x - truth.x, believed.y - truth.y);
  EXPECT_GT(drift_m, 1e-3);
  EXPECT_LT(drift_m, 0.4);
}

TEST(SimulationRun, TimesOutAtTheLimit) {
  SimulationSetup setup = hall();
  setup.scenario.timeLimit_s = 2.0;
  const RunSummary summary = runSimulation(setup, 1);
  EXPECT_EQ(summary.outcome, Outcome::Timeout);
  EXPECT_FALSE(summary.reason.empty());
  EXPECT_NEAR(summary.duration_s, 2.0, 1e-6);
  EXPECT_EQ(summary.cycles, 21);
}

TEST(SimulationRun, GivesUpWithAReasonWhenTheGoalIsUnreachable) {
  SimulationSetup setup = hall();
  setup.world.walls["across"].points_m = {{3.0, -2.0}, {3.0, 2.0}};
  const RunSummary summary = runSimulation(setup, 1);
  EXPECT_EQ(summary.outcome, Outcome::Stuck);
  EXPECT_THAT(summary.reason, HasSubstr("no path"));
  EXPECT_FALSE(summary.contact);
  EXPECT_GT(summary.blockedCycles, 10);
}

TEST(SimulationRun, StopsWhenTheObserverSaysSo) {
  SimulationSetup setup = hall();
  int cycles = 0;
  const RunSummary summary =
      runSimulation(setup, 1, [&](const SimulationMoment&) { return ++cycles < 5; });
  EXPECT_EQ(summary.outcome, Outcome::Error);
  EXPECT_EQ(summary.reason, "interrupted");
  EXPECT_EQ(cycles, 5);
  EXPECT_EQ(summary.cycles, 5);
  EXPECT_NEAR(summary.duration_s, 0.4, 1e-9);  // braking afterwards does not count
}

TEST(SimulationRun, FailureOfTheObserverEndsTheRunWithItsReason) {
  const RunSummary summary = runSimulation(hall(), 1, [](const SimulationMoment& m) -> bool {
    if (m.record.index == 3) throw Error("cycles.csv", "the disk is full", Error::Kind::Run);
    return true;
  });
  EXPECT_EQ(summary.outcome, Outcome::Error);
  EXPECT_EQ(summary.reason, "cycles.csv: the disk is full");
  EXPECT_EQ(summary.cycles, 4);
}

TEST(SimulationRun, PassesItsWaypoints) {
  SimulationSetup setup = hall();
  setup.scenario.goals = {{2.0, 1.2, 0.0}, {4.0, -1.2, 0.0}, {6.0, 0.0, 0.0}};
  double nearest_m[] = {9.0, 9.0};
  const RunSummary summary = runSimulation(setup, 1, [&](const SimulationMoment& m) {
    for (const int i : {0, 1}) {
      const auto& goal = setup.scenario.goals[static_cast<std::size_t>(i)];
      nearest_m[i] =
          std::min(nearest_m[i], std::hypot(goal.x - m.truth.pose.x, goal.y - m.truth.pose.y));
    }
    return true;
  });
  EXPECT_EQ(summary.outcome, Outcome::Goal) << summary.reason;
  EXPECT_LT(nearest_m[0], 0.4);
  EXPECT_LT(nearest_m[1], 0.4);
}

TEST(SimulationRun, WorksWithoutAMap) {
  SimulationSetup setup = hall(7.0);
  setup.scenario.map = "none";
  const RunSummary summary = runSimulation(setup, 1);
  EXPECT_EQ(summary.outcome, Outcome::Goal) << summary.reason;
  EXPECT_FALSE(summary.minClearance_m.has_value());  // nobody there
}

TEST(SimulationRun, LongRobotDrivesThroughTheCorridorOfS1) {
  SimulationSetup setup = s1(2);
  setup.navigation.footprint.polygon = {{0.4, 0.25}, {-0.4, 0.25}, {-0.4, -0.25}, {0.4, -0.25}};
  setup.world.pedestrians.clear();
  const RunSummary summary = runSimulation(setup, 1);
  EXPECT_EQ(summary.outcome, Outcome::Goal) << summary.reason;
}

}  // namespace
}  // namespace bslnav
