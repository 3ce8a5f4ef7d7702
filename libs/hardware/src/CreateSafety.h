#pragma once

#include <bslnav/hardware/CreateParameters.h>
#include <bslnav/hardware/CreateProtocol.h>
#include <mrpt/math/TTwist2D.h>

namespace bslnav {

/** What a Create may be told, from what it senses: with a bump or a cliff backwards only, with a
 * wheel off the floor nothing. */
class CreateSafety {
 public:
  void sensed(const CreateSensors& sensors);

  /** The wheels for a velocity in the robot frame, or standstill. */
  CreateWheels permitted(const mrpt::math::TTwist2D& wanted,
                         const CreateParameters& parameters) const;

  /** Whether it takes no commands, but would if it were asked to: a wheel drop, or a cliff, makes
   * it passive, and it would never drive again. */
  bool needsSafeMode() const;
  void askedForSafeMode() { leftSafeMode_ = false; }

 private:
  CreateSensors sensors_;
  // Whatever mode it tells: firmware that counts from 1 calls passive 2.
  bool leftSafeMode_ = false;
};

}  // namespace bslnav
