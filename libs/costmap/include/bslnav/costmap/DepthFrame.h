#pragma once

#include <bslnav/costmap/FloorCheck.h>
#include <mrpt/math/TPoint3D.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace bslnav {

/** A depth image made ready for the control cycle: checked depths, and each pixel's ray in the
 * robot frame (x forward, y left, z up from the floor; metres).
 *
 * The point of column u and row v at depth d is origin + d·(column[u] + row[v]): the rays of a
 * pinhole camera without distortion, which is what depth cameras deliver and MRPT assumes. Built
 * from MRPT's observation; assigning an image of the same size again does not allocate. */
class DepthFrame {
 public:
  enum class Status : std::uint8_t {
    Ok,
    NoImage,        ///< there is no range image
    NoCalibration,  ///< the camera's parameters are missing or not of this image
    NoDepth,        ///< no pixel has a depth
    FloorAmiss      ///< the widest flat surface is not where the floor is: the pose is wrong
  };
  struct Rays {
    std::vector<float> x, y, z;
  };

  /** Takes over an observation whose range image is loaded. Depths of 0 and beyond the sensor's
   * maximum range are none.
   * @param robotFromThen where the robot was when the image was taken, seen from where it is now */
  void assign(const mrpt::obs::CObservation3DRangeScan& image,
              const mrpt::math::TPose2D& robotFromThen = {});

  Status status() const { return status_; }
  /** When the status is FloorAmiss: where the floor appears, below the camera, and how tilted. */
  double floorHeight_m() const { return floorHeight_m_; }
  double floorTilt_rad() const { return floorTilt_rad_; }

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /** Row v of the depths [m] along the optical axis; 0 where there is none. */
  const float* depthRow(int v) const {
    return depth_m_.data() + std::size_t(v) * std::size_t(columns_);
  }
  const Rays& columnRays() const { return columnRays_; }
  const Rays& rowRays() const { return rowRays_; }
  const mrpt::math::TPoint3Df& origin() const { return origin_; }  ///< of the camera
  double yaw_rad() const { return yaw_rad_; }                      ///< of the optical axis
  double maxRange_m() const { return maxRange_m_; }
  /** Columns, rows, fx, fy, cx, cy, height, pitch, roll: equal as long as only the robot moves. */
  using Geometry = std::array<double, 9>;
  const Geometry& geometry() const { return geometry_; }

  /** The point of a pixel with a depth. */
  mrpt::math::TPoint3Df point(int u, int v) const;
  /** The points of all pixels with a depth, row by row. */
  std::vector<mrpt::math::TPoint3Df> points() const;

 private:
  bool isCalibrated(const mrpt::obs::CObservation3DRangeScan& image) const;
  void setRays(const mrpt::obs::CObservation3DRangeScan& image,
               const mrpt::math::TPose2D& robotFromThen);
  bool convert(const mrpt::obs::CObservation3DRangeScan& image);
  bool isFloorAmiss();

  Status status_ = Status::NoImage;
  int columns_ = 0, rows_ = 0;
  double yaw_rad_ = 0.0, maxRange_m_ = 0.0, floorHeight_m_ = 0.0, floorTilt_rad_ = 0.0;
  FloorCheck floor_;
  std::vector<float> depth_m_;
  Rays columnRays_, rowRays_;
  Geometry geometry_{};
  mrpt::math::TPoint3Df origin_;
};

/** The status in words, for reports: empty when it is Ok. */
std::string describe(const DepthFrame& frame);

}  // namespace bslnav
