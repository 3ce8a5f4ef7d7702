#pragma once

#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace bslnav::test {

/** An upright box in the robot frame of the moment of the picture [m]. */
struct SceneBox {
  double xMin, xMax, yMin, yMax, zMin, zMax;
};

/** A floor at `floor_m` and boxes, and depth images of them by exact rays. */
struct DepthScene {
  std::vector<SceneBox> boxes;
  double floor_m = 0.0;

  /** Distance along a ray in units of its direction; infinity for none. */
  double hit(const mrpt::math::TPoint3D& from, const mrpt::math::TPoint3D& direction) const {
    double nearest = std::numeric_limits<double>::infinity();
    if (direction.z < 0.0) nearest = (floor_m - from.z) / direction.z;
    for (const SceneBox& box : boxes) {
      double enter = 0.0, leave = nearest;
      const auto clip = [&](double origin, double d, double low, double high) {
        const double a = (low - origin) / d, b = (high - origin) / d;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
      };
      clip(from.x, direction.x == 0.0 ? 1e-12 : direction.x, box.xMin, box.xMax);
      clip(from.y, direction.y == 0.0 ? 1e-12 : direction.y, box.yMin, box.yMax);
      clip(from.z, direction.z == 0.0 ? 1e-12 : direction.z, box.zMin, box.zMax);
      if (enter < leave && enter > 0.0) nearest = enter;
    }
    return nearest;
  }

  /** A picture of 90 degrees from side to side, from a camera on the robot. */
  mrpt::obs::CObservation3DRangeScan picture(const mrpt::poses::CPose3D& robotFromCamera,
                                             int columns = 80, int rows = 60,
                                             double maxRange_m = 6.0) const {
    mrpt::obs::CObservation3DRangeScan image;
    image.sensorLabel = "camera";
    image.sensorPose = robotFromCamera;
    image.hasRangeImage = image.range_is_depth = true;
    image.rangeUnits = 0.001f;
    image.maxRange = static_cast<float>(maxRange_m);
    image.rangeImage.setSize(rows, columns);
    auto& camera = image.cameraParams;
    camera.ncols = static_cast<std::uint32_t>(columns);
    camera.nrows = static_cast<std::uint32_t>(rows);
    camera.setIntrinsicParamsFromValues(0.5 * columns, 0.5 * columns, 0.5 * (columns - 1),
                                        0.5 * (rows - 1));
    const auto origin = robotFromCamera.translation();
    for (int v = 0; v < rows; ++v)
      for (int u = 0; u < columns; ++u) {
        const auto tip = robotFromCamera.composePoint(mrpt::math::TPoint3D(
            1.0, (camera.cx() - u) / camera.fx(), (camera.cy() - v) / camera.fy()));
        const double depth = hit(origin, tip - origin);
        image.rangeImage(v, u) =
            depth < maxRange_m ? static_cast<std::uint16_t>(std::lround(depth * 1000.0)) : 0;
      }
    return image;
  }
};

/** A camera at a height, looking ahead and down by a pitch. */
inline mrpt::poses::CPose3D cameraAt(double z_m, double pitch_rad = 0.0, double yaw_rad = 0.0) {
  return {0.0, 0.0, z_m, yaw_rad, pitch_rad, 0.0};
}

}  // namespace bslnav::test
