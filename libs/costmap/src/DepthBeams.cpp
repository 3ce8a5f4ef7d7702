#include <bslnav/costmap/DepthBeams.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bslnav {

bool DepthBeams::layOut(const DepthFrame& frame) {
  if (frame.geometry() == layout_) return false;
  layout_ = frame.geometry();
  const auto& column = frame.columnRays();
  const auto& row = frame.rowRays();
  const auto rows = static_cast<std::size_t>(frame.rows());
  columns_ = static_cast<std::size_t>(frame.columns());
  const double yaw = frame.yaw_rad(), c = std::cos(yaw), s = std::sin(yaw);
  const double widestPixel = 1.0 / frame.geometry()[2];  // else some beams would get none
  width_rad_ = std::max(askedWidth_rad_, 1.05 * widestPixel);
  const int half = static_cast<int>(std::ceil(M_PI / width_rad_));
  beamOf_.resize(columns_ * rows);
  distancePerDepth_.resize(columns_ * rows);
  const auto most = static_cast<std::size_t>(2 * half + 1);
  std::vector<float> start(most, std::numeric_limits<float>::max());
  std::vector<float> steepest(most, std::numeric_limits<float>::lowest());
  int first = 2 * half, last = 0;
  for (std::size_t v = 0; v < rows; ++v)
    for (std::size_t u = 0; u < columns_; ++u) {
      const double x = column.x[u] + row.x[v], y = column.y[u] + row.y[v];
      const double angle = std::atan2(c * y - s * x, c * x + s * y);
      const int beam =
          std::clamp(half + static_cast<int>(std::lround(angle / width_rad_)), 0, 2 * half);
      const std::size_t pixel = v * columns_ + u;
      beamOf_[pixel] = static_cast<std::uint16_t>(beam);
      distancePerDepth_[pixel] = static_cast<float>(std::hypot(x, y));
      first = std::min(first, beam);
      last = std::max(last, beam);
      const float up = column.z[u] + row.z[v];  // the floor is met at depth height/−up
      auto& nearest = start[static_cast<std::size_t>(beam)];
      if (up < 0.0f) nearest = std::min(nearest, frame.origin().z / -up * distancePerDepth_[pixel]);
      auto& highest = steepest[static_cast<std::size_t>(beam)];
      highest = std::max(highest, up / distancePerDepth_[pixel]);
    }
  for (auto& beam : beamOf_) beam = static_cast<std::uint16_t>(beam - first);
  firstAngle_rad_ = (first - half) * width_rad_;
  start_m_.assign(start.begin() + first, start.begin() + last + 1);
  steepest_.assign(steepest.begin() + first, steepest.begin() + last + 1);
  return true;
}

void DepthBeams::startScan(const DepthFrame& frame, PlanarScan& scan) const {
  scan.reset({frame.origin().x, frame.origin().y, frame.yaw_rad()}, frame.maxRange_m(), size());
  scan.start_m.assign(start_m_.begin(), start_m_.end());
  scan.steepest.assign(steepest_.begin(), steepest_.end());
  scan.top_m.assign(size(), 0.0f);
  scan.sensorHeight_m = static_cast<double>(frame.origin().z);
  for (std::size_t i = 0; i < size(); ++i) {
    const double angle = frame.yaw_rad() + firstAngle_rad_ + static_cast<double>(i) * width_rad_;
    scan.cosine[i] = static_cast<float>(std::cos(angle));
    scan.sine[i] = static_cast<float>(std::sin(angle));
  }
}

}  // namespace bslnav
