#pragma once

#include <bslnav/planning/RobotLimits.h>
#include <mrpt/math/TTwist2D.h>

namespace bslnav {

/** The velocities that can be reached within some time (Fox et al. 1997: one control period). */
struct DynamicWindow {
  double vMin = 0.0, vMax = 0.0;    ///< forward speed [m/s]
  double wMin = 0.0, wMax = 0.0;    ///< turning rate [rad/s]
  double vyMin = 0.0, vyMax = 0.0;  ///< lateral speed, positive to the left [m/s]
};

/** The window never drives backwards: a robot that rolls backwards, or is faster than the cap or
 * the limits, is led back as fast as its limits allow.
 *  @param speedCap_mps highest speed wanted now, at least 0, for example to stop at the goal */
DynamicWindow dynamicWindow(const mrpt::math::TTwist2D& current, const RobotLimits& limits,
                            double window_s, double speedCap_mps);

/** A velocity of the window, as far towards it as `current` comes within the window's time: the
 * window bounds vx and vy one by one, in its corners the vector (vx, vy) would break the limits. */
mrpt::math::TTwist2D withinWindow(mrpt::math::TTwist2D velocity,
                                  const mrpt::math::TTwist2D& current, const RobotLimits& limits,
                                  double window_s, double speedCap_mps);

/** Sample i of n spread evenly over [low, high]; where the interval holds zero, the sample nearest
 * to zero is zero, so that standing still and driving straight are always among the candidates. */
double sampleOf(double low, double high, int i, int n);

}  // namespace bslnav
