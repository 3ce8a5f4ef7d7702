#pragma once

#include <bslnav/costmap/PlanarScan.h>

#include <cmath>
#include <limits>
#include <vector>

namespace bslnav::test {

inline constexpr float kNone = 1000.0f;  ///< a beam without return
inline const float kLost = std::numeric_limits<float>::quiet_NaN();

/** A scan with these ranges over `aperture_rad` counterclockwise, maximum range 10 m. */
inline PlanarScan scanOf(const std::vector<float>& ranges_m, double aperture_rad = M_PI,
                         const mrpt::math::TPose2D& robotFromSensor = {}) {
  mrpt::obs::CObservation2DRangeScan observation;
  observation.aperture = static_cast<float>(aperture_rad);
  observation.maxRange = 10.0f;
  observation.sensorPose = mrpt::poses::CPose3D(robotFromSensor.x, robotFromSensor.y, 0.0,
                                                robotFromSensor.phi, 0.0, 0.0);
  observation.resizeScan(ranges_m.size());
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    observation.setScanRange(i, ranges_m[i]);
    observation.setScanRangeValidity(i, ranges_m[i] < observation.maxRange);
  }
  PlanarScan scan;
  scan.assign(observation);
  return scan;
}

}  // namespace bslnav::test
