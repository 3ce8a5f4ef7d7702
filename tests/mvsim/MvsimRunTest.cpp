#include <bslnav/mvsim/MvsimSimulator.h>

#include "../evaluation/EvaluationRig.h"

namespace bslnav {
namespace {

RunSummary driveS1(int method, std::uint64_t seed) {
  SimulationEngines engines;
  engines.add(EngineKind::Mvsim, [](const SimulationCase& simulated) {
    return std::make_unique<MvsimSimulator>(simulated);
  });
  return runSimulation(test::s1(method, {"simulation.engine=mvsim"}), seed, {}, engines);
}

/* As in our simulator, where the robot meets the person at 0.56 m/s. */
TEST(MvsimRun, Method1MeetsThePersonOfS1) {
  const RunSummary summary = driveS1(1, 1);
  EXPECT_EQ(summary.outcome, Outcome::Contact) << summary.reason;
  EXPECT_TRUE(summary.atFault);
  EXPECT_NEAR(summary.impactSpeed_mps.value_or(0.0), 0.5, 0.1);
}

TEST(MvsimRun, Method2ReachesTheGoalOfS1) {
  const RunSummary summary = driveS1(2, 1);
  EXPECT_EQ(summary.outcome, Outcome::Goal) << summary.reason;
  EXPECT_FALSE(summary.contact);
}

TEST(MvsimRun, IsRepeatable) {
  const std::string first = test::resultOf(driveS1(2, 3));
  EXPECT_EQ(test::resultOf(driveS1(2, 3)), first);
  EXPECT_NE(test::resultOf(driveS1(2, 4)), first);
}

}  // namespace
}  // namespace bslnav
