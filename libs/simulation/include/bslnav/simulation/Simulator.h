#pragma once

#include <bslnav/simulation/DepthCamera.h>
#include <bslnav/simulation/LaserSensor.h>
#include <bslnav/simulation/Pedestrian.h>
#include <bslnav/simulation/RayScene.h>
#include <bslnav/simulation/RobotBody.h>
#include <bslnav/simulation/SensorSchedule.h>
#include <bslnav/simulation/SimulatedRobot.h>

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace bslnav {

/** The truth at one moment; map frame unless said otherwise. */
struct SimulationState {
  enum class Contact { Nothing, Person, World };
  struct Person {
    mrpt::math::TPoint2D position;
    double radius_m = 0.0;
    bool started = false;  ///< stays true at the end of the walk
    double speed_mps = 0.0;
  };

  double time_s = 0.0;
  mrpt::math::TPose2D pose;
  mrpt::math::TTwist2D twist;    ///< robot frame
  mrpt::math::TPose2D odometry;  ///< starts at the true pose
  std::vector<Person> people;    ///< by name of the pedestrian, alphabetically
  double clearanceToPeople_m = std::numeric_limits<double>::infinity();
  double clearanceToWorld_m = std::numeric_limits<double>::infinity();
  double minClearanceToPeople_m = std::numeric_limits<double>::infinity();  ///< of all substeps
  Contact contact = Contact::Nothing;  ///< the first one of the run
  double contactTime_s = 0.0;          ///< of that contact
  double speedAtContact_mps = 0.0;     ///< the robot's, never negative
};

/** A world, a robot with lasers and depth cameras, and people, on one simulated clock.
 *
 * The same arguments and commands give the same bits, however many threads run a simulator each.
 * Contact changes nothing: robot and people go through each other, and the caller ends the run.
 */
class Simulator {
 public:
  using Scans = std::vector<mrpt::obs::CObservation2DRangeScan::Ptr>;
  using DepthFrames = std::vector<DepthCamera::Frame::ConstPtr>;

  /** Time 0 of the simulated clock as a time stamp: 2001-09-09 01:46:40 UTC. */
  static constexpr double kEpoch_s = 1e9;
  static constexpr double kSubstep_s = 0.01;

  /** The first scans and depth frames are taken at time 0.
   *  @param lasers,cameras by name, which becomes the sensor label
   *  @throws Error on bad parameters, or when the robot touches something where it starts */
  Simulator(const WorldParameters& world, const SimulatedRobotParameters& robot,
            const std::map<std::string, LaserParameters>& lasers,
            const std::map<std::string, DepthCameraParameters>& cameras,
            const mrpt::math::TPose2D& start, const RobotOutline& outline, std::uint64_t seed);

  /** Drives for `dt_s` in equal substeps of at most 10 ms, each with people, contacts, sensors. */
  void step(const mrpt::math::TTwist2D& command, double dt_s);

  const SimulationState& state() const { return state_; }

  /** The newest scan of each laser that was delivered since the last call, sorted by name.
   *
   *  Its stamp is the simulated time at which it was taken, `kEpoch_s` + time_s. */
  Scans senseScans();
  /** The same for the depth cameras. */
  DepthFrames senseDepth();

 private:
  struct Laser {
    LaserSensor sensor;
    SensorSchedule<mrpt::obs::CObservation2DRangeScan::Ptr> schedule;
  };
  struct Camera {
    DepthCamera sensor;
    SensorSchedule<DepthCamera::Frame::ConstPtr> schedule;
  };

  void substep(const mrpt::math::TTwist2D& command, double dt_s);
  void updateState();
  void updateContact();
  void measure();
  void refuseStartInCollision() const;

  std::vector<WorldShape> shapes_;
  RayScene scene_;
  SimulatedRobot robot_;
  RobotBody body_;
  std::vector<Pedestrian> pedestrians_;
  std::vector<Laser> lasers_;
  std::vector<Camera> cameras_;
  std::vector<mrpt::math::TPoint2D> positions_;  // of the people, in scene order
  SimulationState state_;
};

}  // namespace bslnav
