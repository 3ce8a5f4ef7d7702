#include "CreateSafety.h"

#include <bslnav/hardware/CreateKinematics.h>

namespace bslnav {

void CreateSafety::sensed(const CreateSensors& sensors) {
  sensors_ = sensors;
  if (sensors.wheelDrop || sensors.cliff) leftSafeMode_ = true;
}

CreateWheels CreateSafety::permitted(const mrpt::math::TTwist2D& wanted,
                                     const CreateParameters& parameters) const {
  if (sensors_.wheelDrop || !sensors_.takesCommands()) return {};
  if ((sensors_.cliff || sensors_.bump()) && wanted.vx > 0.0) return {};
  return wheelsOf(wanted, parameters);
}

bool CreateSafety::needsSafeMode() const {
  if (sensors_.wheelDrop || sensors_.cliff) return false;
  return leftSafeMode_ || !sensors_.takesCommands();
}

}  // namespace bslnav
