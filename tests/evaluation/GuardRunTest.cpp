#include "EvaluationRig.h"

namespace bslnav {
namespace {

/** Where the robot runs into the person in Method 1 in about half of all seeds, it stands, if they
 * meet at all, with the guard. */
TEST(GuardRun, NoContactAtFaultInS1) {
  const SimulationSetup plain = test::s1(1), guarded = test::s1(5);
  int contacts = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    contacts += runSimulation(varied(plain, seed), seed).atFault;
    const RunSummary run = runSimulation(varied(guarded, seed), seed);
    EXPECT_FALSE(run.atFault) << "seed " << seed;
    EXPECT_FALSE(run.contact) << "seed " << seed;
  }
  EXPECT_GT(contacts, 0);
}

/** The certificate of every cycle: what was commanded is within the bound, and what binds is a
 * frontier point. */
TEST(GuardRun, EveryCommandIsCertified) {
  int bound = 0;
  runSimulation(varied(test::s1(5), 2), 2, [&bound](const SimulationMoment& moment) {
    const GuardRecord& g = moment.record.guard;
    if (moment.record.motion.mode == MotionMode::Idle) return true;
    EXPECT_TRUE(g.active);
    const auto& command = moment.record.motion.command;
    const bool promised = g.lapse == GuardRecord::Lapse::None;
    if (promised && std::hypot(command.vx, command.vy) >= 0.02) {
      const bool isChosen = !moment.record.motion.blocked;  // else it brakes
      EXPECT_GT(g.slack_m, isChosen ? 0.0 : -GuardParameters{}.noise_m) << moment.record.time_s;
      EXPECT_TRUE(!isChosen || g.impact_mps == 0.0) << moment.record.time_s;
    }
    bound += g.binding.has_value();
    return true;
  });
  EXPECT_GT(bound, 10);
}

/** An empty corridor with an opening: the robot passes it about as fast as with Method 4, in a wide
 * bow. */
TEST(GuardRun, AnEmptyOpeningIsPassedAtSpeed) {
  SimulationSetup proposed = test::s1(4), guarded = test::s1(5);
  for (SimulationSetup* setup : {&proposed, &guarded}) {
    setup->world.pedestrians.clear();
    setup->world.cylinders.clear();
    setup->world.boxes.clear();
  }
  const RunSummary four = runSimulation(proposed, 1), five = runSimulation(guarded, 1);
  ASSERT_TRUE(four.timeToGoal_s && five.timeToGoal_s);
  EXPECT_LT(*five.timeToGoal_s, 1.1 * *four.timeToGoal_s);
}

}  // namespace
}  // namespace bslnav
