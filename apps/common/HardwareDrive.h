#pragma once

#include <bslnav/config/Config.h>
#include <bslnav/evaluation/RunSummary.h>

#include "HardwareSetup.h"
#include "RecordedDrive.h"

namespace bslnav {

/** Drives a real robot to its goal and leaves records and pictures; an interrupt stops the robot
 * first. Where the robot is in them is where it was localised.
 *  @param config that of both setups, to be kept as config.ini
 *  @throws Error when it cannot begin */
RunSummary driveHardware(const SimulationSetup& setup, const HardwareSetup& hardware,
                         const Config& config, const DriveOptions& options);

}  // namespace bslnav
