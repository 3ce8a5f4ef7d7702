#include <bslnav/simulation/DepthCamera.h>
#include <bslnav/simulation/RandomStream.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

const DepthCameraParameters& checked(const std::string& name,
                                     const DepthCameraParameters& parameters) {
  parameters.check(name);
  return parameters;
}

mrpt::img::TCamera calibration(const DepthCameraParameters& parameters) {
  mrpt::img::TCamera camera;
  camera.ncols = static_cast<std::uint32_t>(parameters.columns);
  camera.nrows = static_cast<std::uint32_t>(parameters.rows);
  // The field of view reaches to the outer borders of the outermost pixels.
  camera.setIntrinsicParamsFromValues(
      0.5 * parameters.columns / std::tan(0.5 * parameters.hfov_rad),
      0.5 * parameters.rows / std::tan(0.5 * parameters.vfov_rad), 0.5 * (parameters.columns - 1),
      0.5 * (parameters.rows - 1));
  return camera;
}

mrpt::math::TPoint3Df scaled(const mrpt::math::CMatrixDouble33& axes, int axis, double factor) {
  return {static_cast<float>(axes(0, axis) * factor), static_cast<float>(axes(1, axis) * factor),
          static_cast<float>(axes(2, axis) * factor)};
}

}  // namespace

DepthCamera::DepthCamera(const std::string& name, const DepthCameraParameters& parameters,
                         std::uint64_t seed)
    : parameters_(checked(name, parameters)),
      noise_(parameters, randomStream(seed, "camera/" + name + "/pixels")) {
  blank_.sensorLabel = name;
  blank_.sensorPose = {parameters.x_m,     parameters.y_m,       parameters.z_m,
                       parameters.yaw_rad, parameters.pitch_rad, parameters.roll_rad};
  blank_.cameraParams = blank_.cameraParamsIntensity = calibration(parameters);
  blank_.hasRangeImage = blank_.range_is_depth = true;
  blank_.rangeUnits = DepthNoise::kUnit_m;
  blank_.maxRange = static_cast<float>(parameters.maxRange_m);
  blank_.rangeImage.setSize(parameters.rows, parameters.columns);
  rays_.columns.resize(static_cast<std::size_t>(parameters.columns));
  rays_.rows.resize((static_cast<std::size_t>(parameters.rows) + RayPacket::kSize - 1) /
                    RayPacket::kSize);
}

DepthCamera::Frame::Ptr DepthCamera::unusedFrame() {
  for (const auto& frame : pool_)
    if (frame.use_count() == 1) return frame;
  pool_.push_back(std::make_shared<Frame>(blank_));
  return pool_.back();
}

void DepthCamera::aim(const mrpt::math::TPose2D& mapFromRobot) {
  const auto mapFromSensor =
      mrpt::poses::CPose3D(mrpt::math::TPose3D(mapFromRobot)) + blank_.sensorPose;
  const auto axes = mapFromSensor.getRotationMatrix();  // columns: forward, left, up
  const auto& camera = blank_.cameraParams;
  rays_.origin = {static_cast<float>(mapFromSensor.x()), static_cast<float>(mapFromSensor.y()),
                  static_cast<float>(mapFromSensor.z())};
  const auto forward = scaled(axes, 0, 1.0);
  for (std::size_t u = 0; u < rays_.columns.size(); ++u)
    rays_.columns[u] =
        forward + scaled(axes, 1, (camera.cx() - static_cast<double>(u)) / camera.fx());
  for (std::size_t v = 0; v < rays_.rows.size() * RayPacket::kSize; ++v) {
    const auto row = scaled(axes, 2, (camera.cy() - static_cast<double>(v)) / camera.fy());
    auto& packet = rays_.rows[v / RayPacket::kSize];
    packet.x[v % RayPacket::kSize] = row.x;
    packet.y[v % RayPacket::kSize] = row.y;
    packet.z[v % RayPacket::kSize] = row.z;
  }
}

DepthCamera::Frame::ConstPtr DepthCamera::frame(const RayScene& scene,
                                                const mrpt::math::TPose2D& mapFromRobot,
                                                mrpt::Clock::time_point stamp) {
  auto frame = unusedFrame();
  frame->timestamp = stamp;
  aim(mapFromRobot);
  // A surface that goes on past the maximum range has no edge there.
  scene.trace(rays_, static_cast<float>(parameters_.maxRange_m + parameters_.edgeStep_m));
  noise_.measure(
      {rays_.hits.data(), rays_.columns.size(), static_cast<std::size_t>(parameters_.rows)},
      &frame->rangeImage(0, 0));
  return frame;
}

}  // namespace bslnav
