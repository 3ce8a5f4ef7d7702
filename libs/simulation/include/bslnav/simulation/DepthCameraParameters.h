#pragma once

#include <bslnav/config/ConfigSection.h>

#include <cmath>
#include <string>

namespace bslnav {

/** A depth camera on the robot; defaults: RealSense D435i at half its resolution. */
struct DepthCameraParameters {
  double x_m = 0.0, y_m = 0.0, z_m = 0.6;  ///< in the robot frame; z above the floor
  double yaw_rad = 0.0;
  double pitch_rad = 10.0 / 180.0 * M_PI;  ///< positive looks down, as in MRPT
  double roll_rad = 0.0;
  double hfov_rad = 87.0 / 180.0 * M_PI;
  double vfov_rad = 58.0 / 180.0 * M_PI;
  int columns = 320, rows = 240;
  double minRange_m = 0.3, maxRange_m = 6.0;  ///< of the depth, along the camera's axis
  double rate_hz = 10.0;
  double latency_s = 0.0;               ///< from the measurement to its delivery
  double noiseCoefficient = 0.002;      ///< standard deviation of a depth z: this times z² [1/m]
  double dropoutProbability = 0.01;     ///< of a pixel to see nothing
  double edgeStep_m = 0.3;              ///< neighbours whose depths differ by more are at an edge
  double edgeDropoutProbability = 0.5;  ///< of a pixel at an edge to see nothing, besides the above

  void describe(ConfigSection& section);
  /** @param name of the camera, for the message
   *  @throws Error naming section and key when ranges, fields of view or sizes make no picture */
  void check(const std::string& name) const;
};

}  // namespace bslnav
