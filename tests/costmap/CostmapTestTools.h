#pragma once

#include <bslnav/costmap/CostGrid.h>
#include <bslnav/costmap/PlanarScan.h>
#include <rapidcheck.h>

#include <cmath>
#include <utility>
#include <vector>

namespace bslnav::test {

inline constexpr double kPi = 3.14159265358979323846;

/** A scan with equal steps over `aperture_rad`; a range < 0 makes a beam without return, NaN a
 * dropped one. */
inline PlanarScan makeScan(const std::vector<double>& ranges_m, double aperture_rad,
                           const mrpt::poses::CPose3D& robotFromSensor = {}) {
  mrpt::obs::CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(aperture_rad);
  scan.maxRange = 30.0f;
  scan.sensorPose = robotFromSensor;
  scan.resizeScan(ranges_m.size());
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    scan.setScanRange(i, static_cast<float>(std::abs(ranges_m[i])));
    scan.setScanRangeValidity(i, !(ranges_m[i] < 0.0));
  }
  PlanarScan result;
  result.assign(scan);
  return result;
}

/** One beam straight ahead. */
inline PlanarScan oneBeam(double range_m) { return makeScan({range_m}, 0.0); }

/** A number in [low, high) off any round value, so that nothing lies on the border of a cell by
 * design. */
inline double anyNumber(double low, double high) {
  return low + (high - low) * (*rc::gen::inRange(0, 1'000'003) + 0.37) / 1'000'004.0;
}

inline mrpt::math::TPose2D anyPose(double half_m) {
  return {anyNumber(-half_m, half_m), anyNumber(-half_m, half_m), anyNumber(-kPi, kPi)};
}

/** Hits, beams without return and dropped beams over 360°, from a sensor beside the robot's centre.
 */
inline PlanarScan anyScan(int beams, double farthest_m) {
  std::vector<double> ranges;
  for (int i = 0; i < beams; ++i) {
    const int kind = *rc::gen::inRange(0, 8);
    ranges.push_back(kind == 0 ? -1.0 : kind == 1 ? std::nan("") : anyNumber(0.05, farthest_m));
  }
  return makeScan(ranges, 2.0 * kPi,
                  mrpt::poses::CPose3D(0.1, -0.05, 0.0, anyNumber(-kPi, kPi), 0.0, 0.0));
}

/** A grid of 0.1 m with free, lethal and unknown cells; one of `sparsity` is not free. */
inline CostGrid anyBase(int width, int height, int sparsity) {
  CostGrid grid(width, height, 0.1, 0.0, 0.0);
  for (auto& cost : grid) {
    const int kind = *rc::gen::inRange(0, 2 * sparsity);
    cost = kind == 0 ? kLethalCost : kind == 1 ? kUnknownCost : kFreeCost;
  }
  return grid;
}

inline bool same(const CostGrid& a, const CostGrid& b) {
  return a.data() == b.data() && a.width() == b.width() && a.getXMin() == b.getXMin() &&
         a.getYMin() == b.getYMin();
}

}  // namespace bslnav::test
