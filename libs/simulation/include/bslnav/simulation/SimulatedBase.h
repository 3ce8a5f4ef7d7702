#pragma once

#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>

#include <cstdint>
#include <memory>

namespace bslnav {

/** Which velocities a base can drive: (vx, 0, ω) or (vx, vy, ω), robot frame. */
enum class BaseKinematics : std::uint8_t { DiffDrive, Holonomic };

/** The motion of a simulated base, by MRPT's vehicle models. */
class SimulatedBase {
 public:
  virtual ~SimulatedBase() = default;

  /** Moves for `dt_s` while the velocity changes from one to the other (robot frame).
   *  @param gain how much of a command the motors' lag lets through in `dt_s`, in (0, 1] */
  virtual void move(const mrpt::math::TTwist2D& from, const mrpt::math::TTwist2D& to, double gain,
                    double dt_s) = 0;
  /** True pose in the map. */
  virtual const mrpt::math::TPose2D& pose() const = 0;
};

/** A base at rest at a pose in the map. @param lag_s time constant of its motors */
std::unique_ptr<SimulatedBase> makeSimulatedBase(BaseKinematics kinematics,
                                                 const mrpt::math::TPose2D& start, double lag_s);

}  // namespace bslnav
