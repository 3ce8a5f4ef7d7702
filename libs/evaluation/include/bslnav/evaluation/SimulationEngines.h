#pragma once

#include <bslnav/config/ConfigSection.h>
#include <bslnav/simulation/SimulationEngine.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>

namespace bslnav {

/** Which program moves the simulated robot and looks through its sensors. */
enum class EngineKind : std::uint8_t { Builtin, Mvsim };

struct SimulationParameters {
  EngineKind engine = EngineKind::Builtin;

  void describe(ConfigSection& section);
};

/** The engines that a program has; the built-in one is always there. */
class SimulationEngines {
 public:
  using Factory = std::function<std::unique_ptr<SimulationEngine>(const SimulationCase&)>;

  SimulationEngines();

  void add(EngineKind kind, Factory factory) { factories_[kind] = std::move(factory); }

  /** @throws Error naming section and key when the engine is not there */
  void check(EngineKind kind) const;
  /** An engine at time 0. @throws Error as check() does, and as the engine does about the case */
  std::unique_ptr<SimulationEngine> make(EngineKind kind, const SimulationCase& simulated) const;

 private:
  std::map<EngineKind, Factory> factories_;
};

}  // namespace bslnav
