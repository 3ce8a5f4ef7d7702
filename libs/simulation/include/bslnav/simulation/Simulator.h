#pragma once

#include <bslnav/simulation/RayScene.h>
#include <bslnav/simulation/SensorSchedule.h>
#include <bslnav/simulation/SimulationEngine.h>
#include <bslnav/simulation/SimulationTruth.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace bslnav {

/** The built-in engine.
 *
 * The same arguments and commands give the same bits, however many threads run a simulator each.
 * Contact changes nothing: robot and people go through each other.
 */
class Simulator final : public SimulationEngine {
 public:
  /** The first scans and depth frames are taken at time 0.
   *  @param lasers,cameras by name, which becomes the sensor label
   *  @throws Error on bad parameters, or when the robot touches something where it starts */
  Simulator(const WorldParameters& world, const SimulatedRobotParameters& robot,
            const std::map<std::string, LaserParameters>& lasers,
            const std::map<std::string, DepthCameraParameters>& cameras,
            const mrpt::math::TPose2D& start, const RobotOutline& outline, std::uint64_t seed);
  explicit Simulator(const SimulationCase& c)
      : Simulator(c.world, c.robot, c.lasers, c.cameras, c.start, c.outline, c.seed) {}

  const SimulationState& state() const override { return truth_.state(); }
  Scans senseScans() override;
  DepthFrames senseDepth() override;

 private:
  struct Laser {
    LaserSensor sensor;
    SensorSchedule<mrpt::obs::CObservation2DRangeScan::Ptr> schedule;
  };
  struct Camera {
    DepthCamera sensor;
    SensorSchedule<DepthCamera::Frame::ConstPtr> schedule;
  };

  void substep(const mrpt::math::TTwist2D& command, double dt_s) override;
  void measure();

  RayScene scene_;
  SimulatedRobot robot_;
  SimulationTruth truth_;
  std::vector<Laser> lasers_;
  std::vector<Camera> cameras_;
};

}  // namespace bslnav
