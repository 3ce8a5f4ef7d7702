#pragma once

#include <bslnav/simulation/SensorSchedule.h>
#include <bslnav/simulation/SimulationEngine.h>
#include <bslnav/simulation/SimulationTruth.h>

#include <map>
#include <memory>
#include <vector>

namespace bslnav {

/** MVSim, MRPT's simulator, as an engine: stepped in this process, without window or network.
 *
 * MVSim moves the robot (differential drive, `twist_ideal`: it has the commanded velocity one
 * substep later; limits, lag and latency of the base are not modelled), turns its wheels, whose
 * speeds are the odometry, and casts the lasers' rays. bslnav walks the people and judges contact
 * and clearance. Noise and dropouts of scans are bslnav's, so that runs can be repeated.
 */
class MvsimSimulator final : public SimulationEngine {
 public:
  /** The first scans are taken at time 0.
   *  @throws Error as mvsimWorld() does, when there are depth cameras (MVSim needs a graphics
   * context for them), or when the robot touches something where it starts */
  explicit MvsimSimulator(const SimulationCase& simulated);
  ~MvsimSimulator() override;

  const SimulationState& state() const override { return truth_.state(); }
  Scans senseScans() override;
  DepthFrames senseDepth() override { return {}; }

 private:
  struct World;  // keeps MVSim's headers out of ours
  struct Laser {
    LaserSensor sensor;
    SensorSchedule<mrpt::obs::CObservation2DRangeScan::Ptr> schedule;
  };

  void substep(const mrpt::math::TTwist2D& command, double dt_s) override;
  void measure();

  SimulationTruth truth_;
  std::vector<Laser> lasers_;
  std::unique_ptr<World> world_;
};

}  // namespace bslnav
