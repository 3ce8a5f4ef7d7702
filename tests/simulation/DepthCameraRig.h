#pragma once

#include <bslnav/simulation/DepthCamera.h>

#include <cmath>
#include <vector>

#include "TestWorld.h"

namespace bslnav::test {

inline const mrpt::Clock::time_point kStamp = mrpt::Clock::fromDouble(1e9);

/** A small level camera without noise or dropouts; its middle pixel (32, 24) looks straight ahead.
 */
inline DepthCameraParameters exactCamera() {
  DepthCameraParameters parameters;
  parameters.pitch_rad = 0.0;
  parameters.columns = 65;
  parameters.rows = 49;
  parameters.noiseCoefficient = 0.0;
  parameters.dropoutProbability = parameters.edgeDropoutProbability = 0.0;
  return parameters;
}

/** A wall across the x axis whose face is at `x_m`, higher than a camera sees. */
inline WorldParameters wallAt(double x_m) {
  WorldParameters world;
  world.walls["w"] = wall({x_m + 0.1, -50}, {x_m + 0.1, 50}, 0.2);
  world.walls["w"].zMax_m = 20.0;
  return world;
}

inline DepthCamera::Frame::ConstPtr frameOf(const DepthCameraParameters& parameters,
                                            const RayScene& scene,
                                            const mrpt::math::TPose2D& mapFromRobot = {}) {
  return DepthCamera("camera", parameters, 1).frame(scene, mapFromRobot, kStamp);
}

/** Depth of a pixel in metres; 0 where nothing is seen. */
inline double depth_m(const DepthCamera::Frame& frame, int u, int v) {
  return static_cast<double>(frame.rangeImage(v, u)) * static_cast<double>(frame.rangeUnits);
}

/** The slopes of a pixel's ray, to the left and upward, from the frame's calibration. */
inline double leftSlope(const DepthCamera::Frame& frame, int u) {
  return (frame.cameraParams.cx() - u) / frame.cameraParams.fx();
}
inline double upSlope(const DepthCamera::Frame& frame, int v) {
  return (frame.cameraParams.cy() - v) / frame.cameraParams.fy();
}

/** Depths are rounded to millimetres: half of one, and what single precision adds. */
inline constexpr double kHalfUnit_m = 0.00052;

}  // namespace bslnav::test
