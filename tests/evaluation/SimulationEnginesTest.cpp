#include <bslnav/simulation/Simulator.h>

#include "EvaluationRig.h"

namespace bslnav {
namespace {

using test::errorOf;
using test::hall;
using testing::AllOf;
using testing::HasSubstr;

TEST(SimulationEngines, MvsimIsRefusedWhereItsAdapterIsOff) {
  SimulationSetup setup = hall();
  setup.simulation.engine = EngineKind::Mvsim;
  EXPECT_THAT(errorOf([&] { runSimulation(setup, 1); }),
              AllOf(HasSubstr("[simulation] engine"), HasSubstr("MVSim support is off"),
                    HasSubstr("CMAKE_PREFIX_PATH")));
  EXPECT_THAT(errorOf([] { SimulationEngines().check(EngineKind::Mvsim); }),
              HasSubstr("MVSim support is off"));
}

/* The engine that was added gets the setup's case, and is the one that runs. */
TEST(SimulationEngines, AnAddedEngineIsTheOneThatRuns) {
  SimulationSetup setup = hall();
  setup.simulation.engine = EngineKind::Mvsim;
  SimulationEngines engines;
  std::uint64_t seed = 0;
  engines.add(EngineKind::Mvsim, [&seed](const SimulationCase& simulated) {
    seed = simulated.seed;
    return std::make_unique<Simulator>(simulated);
  });
  const RunSummary summary = runSimulation(setup, 7, {}, engines);
  EXPECT_EQ(summary.outcome, Outcome::Goal);
  EXPECT_EQ(seed, 7u);
}

TEST(SimulationEngines, CasesHaveCamerasOnlyWhenDepthIsEnabled) {
  SimulationSetup setup = hall();
  setup.cameras["front"] = DepthCameraParameters{};
  setup.navigation.depth.enabled = false;
  EXPECT_TRUE(setup.simulationCase(1).cameras.empty());
  setup.navigation.depth.enabled = true;
  EXPECT_EQ(setup.simulationCase(1).cameras.count("front"), 1u);
  EXPECT_EQ(setup.simulationCase(1).lasers.count("front"), 1u);
}

}  // namespace
}  // namespace bslnav
