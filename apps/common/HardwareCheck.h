#pragma once

#include "HardwareSetup.h"
#include "RecordedDrive.h"

namespace bslnav {

/** Opens every device of a real robot and moves nothing: prints a table of what each delivers, and
 * leaves check.png, the cost map that all of them make together.
 *  @return 0 when all deliver, else 1
 *  @throws Error on a configuration that makes no sense */
int checkHardware(const SimulationSetup& setup, const HardwareSetup& hardware,
                  const DriveOptions& options);

}  // namespace bslnav
