#pragma once

#include <bslnav/config/Config.h>
#include <bslnav/evaluation/RunSummary.h>
#include <bslnav/evaluation/SimulationEngines.h>
#include <bslnav/evaluation/SimulationSetup.h>

#include <string>

namespace bslnav {

/** How a run is shown and where it is kept. */
struct DriveOptions {
  std::uint64_t seed = 1;
  std::string out;  ///< directory of the records
  bool quiet = false;
};

/** Drives in the simulator and leaves records and pictures; an interrupt stops the robot.
 *  @param config that of the setup, to be kept as config.ini
 *  @param engines those that the setup may name
 *  @throws Error when it names another, or cannot be run */
RunSummary driveRecorded(const SimulationSetup& setup, const Config& config,
                         const DriveOptions& options, const SimulationEngines& engines = {});

}  // namespace bslnav
