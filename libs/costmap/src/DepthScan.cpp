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

/** Tables of what depends on the camera only. */
void DepthScan::layOut(const DepthFrame& frame) {
  const auto& column = frame.columnRays();
  const auto& row = frame.rowRays();
  const auto columns = static_cast<std::size_t>(frame.columns()),
             rows = static_cast<std::size_t>(frame.rows());
  const double yaw = frame.yaw_rad(), c = std::cos(yaw), s = std::sin(yaw);
  const double widestPixel = 1.0 / frame.geometry()[2];  // else some beams would get none
  const double width = beamWidth_rad_ = std::max(parameters_.beamWidth_rad, 1.05 * widestPixel);
  const int half = static_cast<int>(std::ceil(M_PI / width));
  beamOf_.resize(columns * rows);
  distancePerDepth_.resize(columns * rows);
  std::vector<float> start(static_cast<std::size_t>(2 * half + 1), kNone);
  int first = 2 * half, last = 0;
  for (std::size_t v = 0; v < rows; ++v)
    for (std::size_t u = 0; u < columns; ++u) {
      const double x = column.x[u] + row.x[v], y = column.y[u] + row.y[v];
      const double angle = std::atan2(c * y - s * x, c * x + s * y);
      const int beam = std::clamp(half + static_cast<int>(std::lround(angle / width)), 0, 2 * half);
      const std::size_t pixel = v * columns + u;
      beamOf_[pixel] = static_cast<std::uint16_t>(beam);
      distancePerDepth_[pixel] = static_cast<float>(std::hypot(x, y));
      first = std::min(first, beam);
      last = std::max(last, beam);
      const float down = -(column.z[u] + row.z[v]);  // the floor is met at depth height/down
      auto& nearest = start[static_cast<std::size_t>(beam)];
      if (down > 0.0f)
        nearest = std::min(nearest, frame.origin().z / down * distancePerDepth_[pixel]);
    }
  for (auto& beam : beamOf_) beam = static_cast<std::uint16_t>(beam - first);
  beams_ = last - first + 1;
  firstAngle_rad_ = (first - half) * width;
  start_m_.assign(start.begin() + first, start.begin() + last + 1);
}

const PlanarScan& DepthScan::make(const DepthFrame& frame) {
  const auto columns = static_cast<std::size_t>(frame.columns());
  if (frame.geometry() != layout_) {
    layOut(frame);
    layout_ = frame.geometry();
  }
  for (auto* values : {&obstacle_m_, &floor_m_, &height_m_}) values->resize(columns);
  above_m_.assign(columns, kNone);
  directions_.assign(static_cast<std::size_t>(beams_), {kNone, 0.0f, 0.0f});
  for (int v = 0; v < frame.rows(); ++v) {
    readRow(frame, v);
    takeRow(frame.columns(), v);
    above_m_.swap(obstacle_m_);
  }

  scan_.reset({frame.origin().x, frame.origin().y, frame.yaw_rad()}, frame.maxRange_m(),
              directions_.size());
  scan_.start_m.assign(start_m_.begin(), start_m_.end());
  scan_.top_m.assign(directions_.size(), 0.0f);
  scan_.sensorHeight_m = static_cast<double>(frame.origin().z);
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    const double angle =
        frame.yaw_rad() + firstAngle_rad_ + static_cast<double>(i) * beamWidth_rad_;
    scan_.cosine[i] = static_cast<float>(std::cos(angle));
    scan_.sine[i] = static_cast<float>(std::sin(angle));
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
  measureRow(frame.depthRow(v),
             distancePerDepth_.data() + j * static_cast<std::size_t>(frame.columns()),
             frame.columnRays().z.data(), frame.rowRays().z[j], frame.origin().z,
             static_cast<float>(parameters_.zMin_m), static_cast<float>(parameters_.zMax_m),
             frame.columns(), obstacle_m_.data(), floor_m_.data(), height_m_.data());
}

void DepthScan::takeRow(int columns, int v) {
  const std::uint16_t* beams =
      beamOf_.data() + static_cast<std::size_t>(v) * static_cast<std::size_t>(columns);
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
