#pragma once

#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>

#include <optional>
#include <string>

namespace bslnav {

/** The newest that a base has told. */
struct BaseState {
  double stamp_s = 0.0;          ///< when it was measured, in MRPT's clock (mrpt::Clock)
  mrpt::math::TPose2D odometry;  ///< odometry frame from robot
  mrpt::math::TTwist2D twist;    ///< robot frame: vx, vy [m/s], omega [rad/s]
  std::string halt;              ///< why the base stands by itself, in words; empty: it does not
  std::optional<mrpt::math::TPose2D> mapFromRobot;  ///< from a base that localises itself
};

/** A base that moves: what a driver of one's own has to do. All functions may be called from any
 * thread. */
class Base {
 public:
  /** Stops the base. */
  virtual ~Base() = default;

  /** The newest state; how old it is, its stamp tells.
   *  @throws Error (Run) before the first one, and when the base is gone */
  virtual BaseState state() = 0;

  /** Drives with a velocity in the robot frame until the next command, or until the base's own
   * watchdog has not had one for too long. @throws Error (Run) when the base is gone */
  virtual void drive(const mrpt::math::TTwist2D& command) = 0;

  /** Stops as hard as the base can. */
  virtual void stop() noexcept = 0;
};

}  // namespace bslnav
