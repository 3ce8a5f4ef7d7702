#include <bslnav/config/Config.h>
#include <bslnav/evaluation/SimulationEngines.h>
#include <bslnav/simulation/Simulator.h>

namespace bslnav {

void SimulationParameters::describe(ConfigSection& section) {
  section.choice("engine", engine, {{"builtin", EngineKind::Builtin}, {"mvsim", EngineKind::Mvsim}},
                 "what simulates: bslnav itself, or MRPT's simulator MVSim where bslnav is built "
                 "with it; bslnav-experiment has the first alone");
}

SimulationEngines::SimulationEngines() {
  add(EngineKind::Builtin,
      [](const SimulationCase& simulated) { return std::make_unique<Simulator>(simulated); });
}

void SimulationEngines::check(EngineKind kind) const {
  if (factories_.count(kind) == 0)
    Config::refuse("simulation", "engine",
                   "builtin. MVSim support is off: build with mvsim-simulator found "
                   "(CMAKE_PREFIX_PATH), and run bslnav");
}

std::unique_ptr<SimulationEngine> SimulationEngines::make(EngineKind kind,
                                                          const SimulationCase& simulated) const {
  check(kind);
  return factories_.at(kind)(simulated);
}

}  // namespace bslnav
