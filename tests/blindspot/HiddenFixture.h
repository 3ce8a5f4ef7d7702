#pragma once

#include <bslnav/blindspot/HiddenPeople.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "ScanFixture.h"

namespace bslnav::test {

/** A scan of the full circle with a beam each half degree; `range` is that of a direction. */
inline PlanarScan around(const std::function<double(double)>& range_m) {
  std::vector<float> ranges;
  constexpr int kBeams = 720;
  for (int i = 0; i < kBeams; ++i)
    ranges.push_back(static_cast<float>(range_m(-M_PI + 2.0 * M_PI * i / kBeams)));
  return scanOf(ranges, 2.0 * M_PI * (kBeams - 1) / kBeams, {0.0, 0.0, -M_PI / kBeams});
}

/** The view from the middle of a round room of 3 m with a wall along y = −1 from x = 0.5 on. */
inline double corner(double angle) {
  if (angle >= 0.0 || angle <= -M_PI / 2.0) return 3.0;
  const double range = -1.0 / std::sin(angle);
  return range * std::cos(angle) >= 0.5 ? std::min(3.0, range) : 3.0;
}

inline HiddenPeople people(
    const HiddenPeopleParameters& parameters = {},
    const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map = nullptr) {
  return HiddenPeople(parameters, 0.25, map, {});
}

inline double nearest(const Frontier& frontier, const mrpt::math::TPoint2D& from = {}) {
  double least = 1e9;
  for (const auto& p : frontier)
    least = std::min(least, std::hypot(p.x_m - from.x, p.y_m - from.y));
  return least;
}

}  // namespace bslnav::test
