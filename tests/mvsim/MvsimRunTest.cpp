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

TEST(MvsimRun, Method2ReachesTheGoalOfS1) {
  const RunSummary summary = driveS1(2, 1);
  EXPECT_EQ(summary.outcome, Outcome::Goal) << summary.reason;
  EXPECT_FALSE(summary.contact);
}

TEST(MvsimRun, IsRepeatable) {
  EXPECT_EQ(test::resultOf(driveS1(2, 3)), test::resultOf(driveS1(2, 3)));
}

}  // namespace
}  // namespace bslnav
