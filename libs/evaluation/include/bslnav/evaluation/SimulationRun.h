#pragma once

#include <bslnav/evaluation/RunSummary.h>
#include <bslnav/evaluation/SimulationSetup.h>
#include <bslnav/navigation/NavigationCycle.h>
#include <bslnav/simulation/SimulationEngine.h>

#include <functional>

namespace bslnav {

/** What an observer of a simulated run sees after every control cycle. */
struct SimulationMoment {
  const CycleRecord& record;
  const SimulationState& truth;
  const NavigationCycle& cycle;
  const SensorFrame& frame;  ///< what the robot sensed
};

/** Called after every cycle; returning false interrupts the run: the robot is told to stop, and the
 * outcome is error. */
using SimulationObserver = std::function<bool(const SimulationMoment&)>;

/** Drives the robot of a setup to its goal, in simulated time.
 *
 * The same setup and seed give the same run. However it ends, also by an exception (the outcome is
 * then error), the robot is told to stop.
 *  @param engines among which `setup.simulation` chooses
 *  @throws Error when the setup cannot be run (start in collision, goal outside the map, an engine
 * that is not there) */
RunSummary runSimulation(const SimulationSetup& setup, std::uint64_t seed,
                         const SimulationObserver& observer = {},
                         const SimulationEngines& engines = {});

}  // namespace bslnav
