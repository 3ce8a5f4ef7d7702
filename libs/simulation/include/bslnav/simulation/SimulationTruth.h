#pragma once

#include <bslnav/simulation/Pedestrian.h>
#include <bslnav/simulation/RobotBody.h>
#include <bslnav/simulation/SimulationState.h>
#include <bslnav/simulation/WorldShape.h>

#include <vector>

namespace bslnav {

/** Judges a simulated run, whoever moves the robot: where people walk, how near the robot is to
 * them and to the world, and when it touches. */
class SimulationTruth {
 public:
  /** The robot stands at `start` (map frame) at time 0.
   *  @throws Error on a bad world or outline, or when the robot touches something there */
  SimulationTruth(const WorldParameters& world, const RobotOutline& outline,
                  const mrpt::math::TPose2D& start);

  /** Takes in that the robot moved, straight, for `dt_s`.
   *  @param pose,odometry now, in the map frame @param twist now, in the robot frame */
  void advance(const mrpt::math::TPose2D& pose, const mrpt::math::TTwist2D& twist,
               const mrpt::math::TPose2D& odometry, double dt_s);

  const SimulationState& state() const { return state_; }
  /** Where the people are now, in the map frame, by name. */
  const std::vector<mrpt::math::TPoint2D>& people() const { return positions_; }

 private:
  void update();
  void updateContact();
  void refuseStartInCollision() const;

  std::vector<WorldShape> shapes_;
  RobotBody body_;
  std::vector<Pedestrian> pedestrians_;
  std::vector<mrpt::math::TPoint2D> positions_;
  SimulationState state_;
};

}  // namespace bslnav
