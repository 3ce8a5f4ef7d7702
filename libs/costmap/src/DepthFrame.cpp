#include <bslnav/config/VectorClones.h>
#include <bslnav/costmap/DepthFrame.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace bslnav {
namespace {

using mrpt::math::TPoint3Df;
using mrpt::obs::CObservation3DRangeScan;

/** Depths of one row from the sensor's integers; those above `most` are none. Returns the bits of
 * all depths: 0 if there is none. */
BSLNAV_VECTOR_CLONES unsigned scaleRow(const std::uint16_t* __restrict raw, float unit_m, int most,
                                       int count, float* __restrict depth_m) {
  unsigned bits = 0;
  for (int u = 0; u < count; ++u) {
    const int value = raw[u] <= most ? raw[u] : 0;
    depth_m[u] = static_cast<float>(value) * unit_m;
    bits |= static_cast<unsigned>(value);
  }
  return bits;
}

bool isFinite(const mrpt::poses::CPose3D& pose) {
  return std::isfinite(pose.norm()) && pose.getRotationMatrix().asEigen().allFinite();
}

}  // namespace

void DepthFrame::assign(const CObservation3DRangeScan& image,
                        const mrpt::math::TPose2D& robotFromThen) {
  columns_ = rows_ = 0;
  status_ = Status::NoImage;
  if (!image.hasRangeImage || image.rangeImage.rows() == 0 || image.rangeImage.cols() == 0) return;
  status_ = Status::NoCalibration;
  if (!isCalibrated(image)) return;
  columns_ = static_cast<int>(image.rangeImage.cols());
  rows_ = static_cast<int>(image.rangeImage.rows());
  setRays(image, robotFromThen);
  status_ = Status::NoDepth;
  if (!convert(image)) return;
  status_ = isFloorAmiss() ? Status::FloorAmiss : Status::Ok;
}

bool DepthFrame::isCalibrated(const CObservation3DRangeScan& image) const {
  const auto& camera = image.cameraParams;
  const bool sameSize = static_cast<Eigen::Index>(camera.ncols) == image.rangeImage.cols() &&
                        static_cast<Eigen::Index>(camera.nrows) == image.rangeImage.rows();
  const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  return sameSize && positive(camera.fx()) && positive(camera.fy()) && std::isfinite(camera.cx()) &&
         std::isfinite(camera.cy()) && positive(static_cast<double>(image.rangeUnits)) &&
         isFinite(image.sensorPose);
}

void DepthFrame::setRays(const CObservation3DRangeScan& image,
                         const mrpt::math::TPose2D& robotFromThen) {
  const auto& camera = image.cameraParams;
  const auto& pose = image.sensorPose;
  geometry_ = {static_cast<double>(columns_),
               static_cast<double>(rows_),
               camera.fx(),
               camera.fy(),
               camera.cx(),
               camera.cy(),
               pose.z(),
               pose.pitch(),
               pose.roll()};
  const auto robotFromCamera = mrpt::poses::CPose3D(robotFromThen) + pose;
  const auto rotation = robotFromCamera.getRotationMatrix();
  yaw_rad_ = robotFromCamera.yaw();
  origin_ = {static_cast<float>(robotFromCamera.x()), static_cast<float>(robotFromCamera.y()),
             static_cast<float>(robotFromCamera.z())};
  const auto fill = [&rotation](Rays& rays, int count, auto&& ray) {
    for (auto* values : {&rays.x, &rays.y, &rays.z})
      values->resize(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const mrpt::math::TPoint3D d = ray(static_cast<double>(i));
      const auto turned = [&](int row) {
        return static_cast<float>(rotation(row, 0) * d.x + rotation(row, 1) * d.y +
                                  rotation(row, 2) * d.z);
      };
      rays.x[i] = turned(0);
      rays.y[i] = turned(1);
      rays.z[i] = turned(2);
    }
  };
  // MRPT: the optical axis is the sensor's x, columns run to its right, rows down.
  fill(columnRays_, columns_,
       [&](double u) { return mrpt::math::TPoint3D(0.0, (camera.cx() - u) / camera.fx(), 0.0); });
  fill(rowRays_, rows_,
       [&](double v) { return mrpt::math::TPoint3D(1.0, 0.0, (camera.cy() - v) / camera.fy()); });
}

/** Returns whether any pixel has a depth. */
bool DepthFrame::convert(const CObservation3DRangeScan& image) {
  depth_m_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  constexpr int kLargest = std::numeric_limits<std::uint16_t>::max();
  const double unit_m = static_cast<double>(image.rangeUnits);
  maxRange_m_ = image.maxRange > 0.0f ? static_cast<double>(image.maxRange) : kLargest * unit_m;
  // Units are floats: 6 m in millimetres would be 5999.9997 of them.
  const int most = static_cast<int>(std::min<double>(kLargest, maxRange_m_ / unit_m + 0.01));
  unsigned bits = 0;
  for (int v = 0; v < rows_; ++v) {
    float* row = depth_m_.data() + static_cast<std::size_t>(v) * static_cast<std::size_t>(columns_);
    bits |= scaleRow(&image.rangeImage(v, 0), image.rangeUnits, most, columns_, row);
    if (image.range_is_depth) continue;
    const auto& camera = image.cameraParams;
    for (int u = 0; u < columns_; ++u)  // from the length of the ray to the depth
      row[u] /= static_cast<float>(
          std::hypot(1.0, (camera.cx() - u) / camera.fx(), (camera.cy() - v) / camera.fy()));
  }
  return bits != 0;
}

/** Looks at pairs of pixels above each other: where they differ less in height than in distance, a
 * surface is no wall. What is seen of a floor at all is most of that. */
bool DepthFrame::isFloorAmiss() {
  constexpr int kStride = 6, kPair = 3;
  constexpr float kSteepest = 0.6f;  // rise over distance
  floor_.clear();
  std::size_t samples = 0;
  const TPoint3Df foot(origin_.x, origin_.y, 0.0f);
  for (int v = 0; v + kPair < rows_; v += kStride)
    for (int u = 0; u < columns_; u += kStride) {
      if (!(depthRow(v)[u] > 0.0f && depthRow(v + kPair)[u] > 0.0f)) continue;
      ++samples;
      const TPoint3Df a = point(u, v), b = point(u, v + kPair);
      if (std::abs(a.z - b.z) < kSteepest * (a - b).norm()) floor_.add((a + b) * 0.5f - foot);
    }
  if (floor_.size() < 20 || 10 * floor_.size() < samples) return false;
  const auto plane = floor_.misplacedFloor();
  if (plane) {
    floorHeight_m_ = plane->height_m;
    floorTilt_rad_ = std::atan(std::hypot(plane->rise_x, plane->rise_y));
  }
  return plane.has_value();
}

TPoint3Df DepthFrame::point(int u, int v) const {
  const auto i = static_cast<std::size_t>(u), j = static_cast<std::size_t>(v);
  const float d = depthRow(v)[u];
  return {origin_.x + d * (columnRays_.x[i] + rowRays_.x[j]),
          origin_.y + d * (columnRays_.y[i] + rowRays_.y[j]),
          origin_.z + d * (columnRays_.z[i] + rowRays_.z[j])};
}

std::vector<TPoint3Df> DepthFrame::points() const {
  std::vector<TPoint3Df> points;
  for (int v = 0; v < rows_; ++v)
    for (int u = 0; u < columns_; ++u)
      if (depthRow(v)[u] > 0.0f) points.push_back(point(u, v));
  return points;
}

std::string describe(const DepthFrame& frame) {
  switch (frame.status()) {
    case DepthFrame::Status::NoImage:
      return "no depth image";
    case DepthFrame::Status::NoCalibration:
      return "the camera's calibration is missing or not of this image";
    case DepthFrame::Status::NoDepth:
      return "no pixel has a depth";
    case DepthFrame::Status::FloorAmiss: {
      char text[160];
      std::snprintf(text, sizeof text,
                    "below the camera the floor appears at a height of %.2f m, tilted by %.0f "
                    "degrees: the camera's pose is wrong",
                    frame.floorHeight_m(), frame.floorTilt_rad() * 180.0 / M_PI);
      return text;
    }
    case DepthFrame::Status::Ok:
      break;
  }
  return "";
}

}  // namespace bslnav
