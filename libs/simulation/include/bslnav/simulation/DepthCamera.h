#pragma once

#include <bslnav/simulation/DepthNoise.h>
#include <bslnav/simulation/RayScene.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <cstdint>
#include <string>
#include <vector>

namespace bslnav {

/** Simulates a depth camera: one instantaneous depth picture at a time. */
class DepthCamera {
 public:
  using Frame = mrpt::obs::CObservation3DRangeScan;

  /** @param name the sensor's label, which also names its noise
   *  @throws Error as DepthCameraParameters::check() does */
  DepthCamera(const std::string& name, const DepthCameraParameters& parameters, std::uint64_t seed);

  const DepthCameraParameters& parameters() const { return parameters_; }

  /** A frame from a robot pose in the map, with calibration and pose on the robot (MRPT's sensor
   * axes: x forward, y left, z up).
   *
   *  The range image holds depths in mm, 0 for a pixel that dropped out or sees nothing between
   *  minimum and maximum range. Pixel (u, v) of depth z is at y = (cx − u)/fx·z, height
   *  (cy − v)/fy·z in the sensor frame. Frames that nobody holds any more are used again. */
  Frame::ConstPtr frame(const RayScene& scene, const mrpt::math::TPose2D& mapFromRobot,
                        mrpt::Clock::time_point stamp);

 private:
  Frame::Ptr unusedFrame();
  void aim(const mrpt::math::TPose2D& mapFromRobot);

  DepthCameraParameters parameters_;
  Frame blank_;  // what every frame starts as
  std::vector<Frame::Ptr> pool_;
  RayImage rays_;
  DepthNoise noise_;
};

}  // namespace bslnav
