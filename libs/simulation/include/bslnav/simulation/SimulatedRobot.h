#pragma once

#include <bslnav/config/ConfigSection.h>
#include <bslnav/simulation/SimulatedBase.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>
#include <mrpt/random/RandomGenerators.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace bslnav {

/** What the simulated base can do, and how well it measures what it did. */
struct SimulatedRobotParameters {
  BaseKinematics kinematics = BaseKinematics::DiffDrive;
  double maxSpeed_mps = 1.0;  ///< forward and backward; holonomic: in every direction
  double maxYawRate_radps = 2.0;
  double maxAcceleration_mps2 = 0.5;  ///< of the velocity vector in the robot frame
  double maxDeceleration_mps2 = 0.5;  ///< towards standstill
  double maxYawAcceleration_radps2 = 2.0;
  double lag_s = 0.05;                     ///< time constant of the motors
  double commandLatency_s = 0.0;           ///< from a command to its first effect
  double odometryTranslationStd_m = 0.01;  ///< after 1 m; grows with the root of the distance
  double odometryRotationStd_rad = 1.0 / 180.0 * M_PI;  ///< of the heading after a turn of 1 rad
  double odometryDriftStd_rad = 0.5 / 180.0 * M_PI;     ///< of the heading after 1 m

  void describe(ConfigSection& section);
};

/** A robot whose commands pass a latency, the limits and a first-order lag. */
class SimulatedRobot {
 public:
  /** Starts at rest, with the odometry at the true pose.
   *  @throws Error when a limit is not above 0 */
  SimulatedRobot(const SimulatedRobotParameters& parameters, const mrpt::math::TPose2D& start,
                 std::uint64_t seed);

  /** Drives for `dt_s` (10 ms or less, for accuracy) with a command in the robot frame; a
   *  differential drive takes no notice of vy.
   *
   *  The mean acceleration over `dt_s` keeps the limits: that of the vector (vx, vy) as the robot
   *  sees it, and that of the turn. @throws Error on a command not finite */
  void advance(const mrpt::math::TTwist2D& command, double dt_s);

  /** True pose in the map. */
  const mrpt::math::TPose2D& pose() const { return base_->pose(); }
  /** True velocity in the robot frame. */
  mrpt::math::TTwist2D twist() const { return twist_; }
  /** Pose in the map as the wheels tell it. */
  const mrpt::math::TPose2D& odometry() const { return odometry_; }

 private:
  struct DelayedCommand {
    double due_s;
    mrpt::math::TTwist2D command;
  };

  bool isHolonomic() const { return parameters_.kinematics == BaseKinematics::Holonomic; }
  mrpt::math::TTwist2D delayed(const mrpt::math::TTwist2D& command);
  mrpt::math::TTwist2D reached(const mrpt::math::TTwist2D& wanted, double gain, double dt_s) const;
  void measure(const mrpt::math::TPose2D& motion);

  SimulatedRobotParameters parameters_;
  std::unique_ptr<SimulatedBase> base_;
  double time_s_ = 0.0;
  std::vector<DelayedCommand> queue_;  // commands still on their way
  mrpt::math::TTwist2D active_, twist_;
  mrpt::math::TPose2D odometry_;
  mrpt::random::CRandomGenerator translationNoise_, rotationNoise_;
};

}  // namespace bslnav
