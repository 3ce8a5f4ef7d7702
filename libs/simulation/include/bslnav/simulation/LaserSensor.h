#pragma once

#include <bslnav/config/ConfigSection.h>
#include <bslnav/simulation/RayScene.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/random/RandomGenerators.h>

#include <string>
#include <vector>

namespace bslnav {

/** A horizontal laser range finder on the robot; defaults: Hokuyo URG-04LX. */
struct LaserParameters {
  double x_m = 0.0, y_m = 0.0, z_m = 0.2;  ///< in the robot frame; z above the floor
  double yaw_rad = 0.0;                    ///< middle of the field of view
  double fov_rad = 4.0 / 3.0 * M_PI;
  int beams = 683;
  double minRange_m = 0.02, maxRange_m = 5.6;
  double rate_hz = 10.0;
  double latency_s = 0.0;             ///< from the measurement to its delivery
  double noiseStd_m = 0.01;           ///< standard deviation of a range
  double dropoutProbability = 0.001;  ///< of a beam to see nothing

  void describe(ConfigSection& section);
};

/** Simulates a laser range finder: one instantaneous scan at a time. */
class LaserSensor {
 public:
  /** @param name the sensor's label, which also names its noise
   *  @throws Error when the ranges, the beams or the rate make no scan */
  LaserSensor(const std::string& name, const LaserParameters& parameters, std::uint64_t seed);

  const LaserParameters& parameters() const { return parameters_; }

  /** A scan from a robot pose in the map, counterclockwise.
   *
   *  Beams that hit nothing between minimum and maximum range, or drop out, are invalid with the
   *  maximum range. Scans that nobody holds any more are used again. */
  mrpt::obs::CObservation2DRangeScan::Ptr scan(const RayScene& scene,
                                               const mrpt::math::TPose2D& mapFromRobot,
                                               mrpt::Clock::time_point stamp);

  /** The scan that this laser makes of exact distances [m]: with its range limits, noise and
   * dropouts.
   *  @param distances_m at least one a beam, counterclockwise; infinity where nothing is */
  mrpt::obs::CObservation2DRangeScan::Ptr scan(const std::vector<float>& distances_m,
                                               mrpt::Clock::time_point stamp);

 private:
  mrpt::obs::CObservation2DRangeScan::Ptr unusedScan();
  void measure(float distance_m, mrpt::obs::CObservation2DRangeScan& scan, std::size_t beam);

  LaserParameters parameters_;
  mrpt::obs::CObservation2DRangeScan blank_;  // what every scan starts as
  std::vector<mrpt::obs::CObservation2DRangeScan::Ptr> pool_;
  std::vector<RayPacket> beamDirections_;  // sensor frame
  std::vector<float> distances_m_;         // of the scan at work, a whole packet at the end
  mrpt::random::CRandomGenerator rangeNoise_, dropouts_;
};

}  // namespace bslnav
