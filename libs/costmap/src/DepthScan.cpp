#include <bslnav/config/VectorClones.h>
#include <bslnav/costmap/DepthScan.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bslnav {
namespace {

constexpr float kNone = std::numeric_limits<float>::max();
constexpr float kSameThing_m = 0.15f;  // points this near to each other in a direction are of one

/** Of each pixel in a row: distance seen from above if it is an obstacle, else kNone; distance if
 * it is lower than one, else 0; and height. */
BSLNAV_VECTOR_CLONES void measureRow(const float* __restrict depth_m,
                                     const float* __restrict distancePerDepth,
                                     const float* __restrict columnZ, float rowZ, float originZ,
                                     float zMin, float zMax, int count,
                                     float* __restrict obstacle_m, float* __restrict floor_m,
                                     float* __restrict height_m) {
  for (int u = 0; u < count; ++u) {
    const float d = depth_m[u], distance = d * distancePerDepth[u];
    const float z = originZ + d * (columnZ[u] + rowZ);
    height_m[u] = z;
    const float obstacle = z >= zMin ? distance : kNone;
    const float lower = z <= zMax ? obstacle : kNone;
    obstacle_m[u] = d > 0.0f ? lower : kNone;
    floor_m[u] = z < zMin ? distance : 0.0f;  // 0 without a depth, too
  }
}

}  // namespace

void DepthScanParameters::describe(ConfigSection& section) {
  section.number("obstacle_z_min_m", zMin_m, kPositive, "m",
                 "lower points are floor: above its noise and unevenness");
  section.number("obstacle_z_max_m", zMax_m, kPositive, "m",
                 "higher points pass over the robot: its height");
  section.angle("beam_width_deg", beamWidth_rad, {0.05, 10.0},
                "directions in which the nearest obstacle is looked for are this far apart");
}

const PlanarScan& DepthScan::make(const DepthFrame& frame) {
  const auto columns = static_cast<std::size_t>(frame.columns());
  beams_.layOut(frame);
  for (auto* values : {&obstacle_m_, &floor_m_, &height_m_}) values->resize(columns);
  above_m_.assign(columns, kNone);
  directions_.assign(beams_.size(), {kNone, 0.0f, 0.0f});
  for (int v = 0; v < frame.rows(); ++v) {
    readRow(frame, v);
    takeRow(frame.columns(), v);
    above_m_.swap(obstacle_m_);
  }

  beams_.startScan(frame, scan_);
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    const Direction& direction = directions_[i];
    scan_.top_m[i] = direction.top_m;
    if (direction.nearest_m < kNone)
      scan_.setBeam(i, PlanarScan::Beam::Hit, direction.nearest_m);
    else if (direction.farthest_m > 0.0f)
      scan_.setBeam(i, PlanarScan::Beam::NoReturn, direction.farthest_m);
  }
  return scan_;
}

void DepthScan::readRow(const DepthFrame& frame, int v) {
  const auto j = static_cast<std::size_t>(v);
  measureRow(frame.depthRow(v), beams_.distanceRow(v), frame.columnRays().z.data(),
             frame.rowRays().z[j], frame.origin().z, static_cast<float>(parameters_.zMin_m),
             static_cast<float>(parameters_.zMax_m), frame.columns(), obstacle_m_.data(),
             floor_m_.data(), height_m_.data());
}

void DepthScan::takeRow(int columns, int v) {
  const std::uint16_t* beams = beams_.beamRow(v);
  for (std::size_t u = 0; u < static_cast<std::size_t>(columns); ++u) {
    Direction& direction = directions_[beams[u]];
    direction.farthest_m = std::max(direction.farthest_m, floor_m_[u]);
    const float pair_m = std::max(obstacle_m_[u], above_m_[u]);
    if (pair_m - kSameThing_m >= direction.nearest_m) continue;
    const bool same = pair_m + kSameThing_m > direction.nearest_m;
    direction.top_m = same ? std::max(direction.top_m, height_m_[u]) : height_m_[u];
    direction.nearest_m = std::min(direction.nearest_m, pair_m);
  }
}

}  // namespace bslnav
