#pragma once

#include <bslnav/simulation/LaserSensor.h>
#include <bslnav/simulation/SimulatedRobot.h>
#include <bslnav/simulation/WorldParameters.h>

namespace bslnav::test {

inline constexpr double kRadPerDeg = M_PI / 180.0;

/** A wall through two points whose face is `thickness_m / 2` in front of them. */
inline WallParameters wall(mrpt::math::TPoint2D from, mrpt::math::TPoint2D to,
                           double thickness_m = 0.1) {
  WallParameters parameters;
  parameters.points_m = {from, to};
  parameters.thickness_m = thickness_m;
  return parameters;
}

inline BoxParameters box(mrpt::math::TPose2D pose, double length_m, double width_m,
                         double zMin_m = 0.0, double zMax_m = 1.0) {
  return {pose, length_m, width_m, zMin_m, zMax_m, true};
}

inline PedestrianParameters walker(std::vector<mrpt::math::TPoint2D> path, double speed_mps) {
  PedestrianParameters parameters;
  parameters.path_m = std::move(path);
  parameters.speed_mps = speed_mps;
  return parameters;
}

/** A laser at the robot's centre without noise. */
inline LaserParameters exactLaser() {
  LaserParameters parameters;
  parameters.noiseStd_m = parameters.dropoutProbability = 0.0;
  return parameters;
}

/** A robot that obeys at once and measures its motion without error. */
inline SimulatedRobotParameters idealRobot() {
  SimulatedRobotParameters parameters;
  parameters.maxAcceleration_mps2 = parameters.maxDeceleration_mps2 = 1e6;
  parameters.maxYawAcceleration_radps2 = 1e6;
  parameters.lag_s = 0.0;
  parameters.odometryTranslationStd_m = 0.0;
  parameters.odometryRotationStd_rad = parameters.odometryDriftStd_rad = 0.0;
  return parameters;
}

}  // namespace bslnav::test
