#pragma once

#include <bslnav/simulation/DepthCamera.h>
#include <bslnav/simulation/LaserSensor.h>
#include <bslnav/simulation/RobotBody.h>
#include <bslnav/simulation/SimulatedRobot.h>
#include <bslnav/simulation/SimulationState.h>
#include <bslnav/simulation/WorldParameters.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace bslnav {

/** What is simulated: a world, a robot with its sensors in it, and the seed of all noise. */
struct SimulationCase {
  WorldParameters world;
  SimulatedRobotParameters robot;
  std::map<std::string, LaserParameters> lasers;  ///< by name, which becomes the sensor label
  std::map<std::string, DepthCameraParameters> cameras;
  mrpt::math::TPose2D start;  ///< in the map
  RobotOutline outline;
  std::uint64_t seed = 1;
};

/** A world, a robot with lasers and depth cameras, and people, on one simulated clock.
 *
 * Contact ends nothing by itself: the state tells of it, and the caller ends the run. */
class SimulationEngine {
 public:
  using Scans = std::vector<mrpt::obs::CObservation2DRangeScan::Ptr>;
  using DepthFrames = std::vector<DepthCamera::Frame::ConstPtr>;

  /** Time 0 of the simulated clock as a time stamp: 2001-09-09 01:46:40 UTC. */
  static constexpr double kEpoch_s = 1e9;
  static constexpr double kSubstep_s = 0.01;

  virtual ~SimulationEngine() = default;

  /** Drives for `dt_s` with a command in the robot frame, in equal substeps of at most 10 ms, each
   * with people, contacts, sensors.
   *  @throws Error (Run) on a command not finite */
  void step(const mrpt::math::TTwist2D& command, double dt_s);

  virtual const SimulationState& state() const = 0;

  /** The newest scan of each laser that was delivered since the last call, sorted by name.
   *
   *  Its stamp is the simulated time at which it was taken, `kEpoch_s` + time_s. */
  virtual Scans senseScans() = 0;
  /** The same for the depth cameras. */
  virtual DepthFrames senseDepth() = 0;

 private:
  virtual void substep(const mrpt::math::TTwist2D& command, double dt_s) = 0;
};

}  // namespace bslnav
