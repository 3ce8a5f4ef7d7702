#pragma once

#include <bslnav/config/ConfigSection.h>
#include <mrpt/math/TTwist2D.h>

namespace bslnav {

/** What the robot's base can do; every command keeps within it. Of a robot that moves sideways,
 * too, speed and acceleration are those of the vector (vx, vy) as the robot sees it. */
struct RobotLimits {
  double maxSpeed_mps = 2.0 / 3.6;  ///< paper: 2.0 km/h
  double maxYawRate_radps = 1.0;
  double acceleration_mps2 = 0.5;
  double deceleration_mps2 = 0.5;
  double yawAcceleration_radps2 = 2.0;
  double response_s = 0.3;           ///< how far the measured velocity may trail the commanded one
  double maxLateralSpeed_mps = 0.0;  ///< to either side; 0: the robot cannot move sideways

  void describe(ConfigSection& section);
};

/** The velocity that the next command starts from: the last command as far as the base may not have
 * followed it yet, else what was measured. Starting from the measured velocity alone, a base that
 * lags would be told to brake ever anew and take far longer to stop than its deceleration allows.
 */
mrpt::math::TTwist2D commandBase(const mrpt::math::TTwist2D& measured,
                                 const mrpt::math::TTwist2D& lastCommand,
                                 const RobotLimits& limits);

/** The command of one control period that brings the robot nearer to a standstill, as fast as the
 * limits allow. */
mrpt::math::TTwist2D brake(const mrpt::math::TTwist2D& current, const RobotLimits& limits,
                           double period_s);

/** The command nearest to `wanted` that the limits allow one control period after `current`. With
 * lateral motion: as far as they allow on the straight line from one vector (vx, vy) to the other,
 * so that both components arrive together; slowing down until that line is nearest to standstill,
 * speeding up from there. */
mrpt::math::TTwist2D limited(const mrpt::math::TTwist2D& wanted,
                             const mrpt::math::TTwist2D& current, const RobotLimits& limits,
                             double period_s);

/** Speed of a velocity: the length of (vx, vy); vx with its sign when there is no lateral part. */
double speedOf(const mrpt::math::TTwist2D& twist);
/** The same of a measured velocity: what a robot that cannot move sideways measures as vy is noise.
 */
double speedOf(const mrpt::math::TTwist2D& measured, const RobotLimits& limits);

/** The speed that, driven for one period and then braked from period to period, ends after
 * `distance`: highest speed now from which the robot still stops there. Metres or radians.
 *  @param distance,deceleration at least 0 and above 0 */
double stoppingSpeed(double distance, double deceleration, double period_s);

}  // namespace bslnav
