#pragma once

#include <bslnav/config/ConfigSection.h>
#include <mrpt/kinematics/CVehicleSimul_DiffDriven.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>
#include <mrpt/random/RandomGenerators.h>

#include <cstdint>
#include <vector>

namespace bslnav {

/** What the simulated base can do, and how well it measures what it did. */
struct SimulatedRobotParameters {
  double maxSpeed_mps = 1.0;  ///< forward and backward
  double maxYawRate_radps = 2.0;
  double maxAcceleration_mps2 = 0.5;
  double maxDeceleration_mps2 = 0.5;  ///< towards standstill
  double maxYawAcceleration_radps2 = 2.0;
  double lag_s = 0.05;                     ///< time constant of the motors
  double commandLatency_s = 0.0;           ///< from a command to its first effect
  double odometryTranslationStd_m = 0.01;  ///< after 1 m; grows with the root of the distance
  double odometryRotationStd_rad = 1.0 / 180.0 * M_PI;  ///< of the heading after a turn of 1 rad
  double odometryDriftStd_rad = 0.5 / 180.0 * M_PI;     ///< of the heading after 1 m

  void describe(ConfigSection& section);
};

/** A differential-drive robot: commands pass a latency, the limits and MRPT's first-order lag. */
class SimulatedRobot {
 public:
  /** Starts at rest, with the odometry at the true pose.
   *  @throws Error when a limit is not above 0 */
  SimulatedRobot(const SimulatedRobotParameters& parameters, const mrpt::math::TPose2D& start,
                 std::uint64_t seed);

  /** Drives for `dt_s` (10 ms or less, for accuracy) with a command in the robot frame, without vy.
   *
   *  The mean acceleration over `dt_s` keeps the limits. @throws Error on a command not finite */
  void advance(const mrpt::math::TTwist2D& command, double dt_s);

  /** True pose in the map. */
  const mrpt::math::TPose2D& pose() const { return vehicle_.getCurrentGTPose(); }
  /** True velocity in the robot frame. */
  mrpt::math::TTwist2D twist() const { return twist_; }
  /** Pose in the map as the wheels tell it. */
  const mrpt::math::TPose2D& odometry() const { return odometry_; }

 private:
  /** MRPT's model, advanced by exactly the time asked for. */
  class Vehicle : public mrpt::kinematics::CVehicleSimul_DiffDriven {
   public:
    void advance(double dt_s);
  };
  struct DelayedCommand {
    double due_s;
    mrpt::math::TTwist2D command;
  };

  mrpt::math::TTwist2D delayed(const mrpt::math::TTwist2D& command);
  void measure(const mrpt::math::TPose2D& motion);

  SimulatedRobotParameters parameters_;
  Vehicle vehicle_;
  double time_s_ = 0.0;
  std::vector<DelayedCommand> queue_;  // commands still on their way
  mrpt::math::TTwist2D active_, twist_;
  mrpt::math::TPose2D odometry_;
  mrpt::random::CRandomGenerator translationNoise_, rotationNoise_;
};

}  // namespace bslnav
