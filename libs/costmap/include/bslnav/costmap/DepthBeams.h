#pragma once

#include <bslnav/costmap/DepthFrame.h>
#include <bslnav/costmap/PlanarScan.h>

#include <cstdint>
#include <vector>

namespace bslnav {

/** Tables of a depth camera for making a horizontal scan of its images: the beam of each pixel, and
 * how its depth becomes a distance seen from above.
 *
 * Beams run counterclockwise in equal steps. The tables depend on the camera's geometry only, not
 * on where the robot stands. */
class DepthBeams {
 public:
  /** @param width_rad of a beam; at least a pixel's width is taken */
  explicit DepthBeams(double width_rad = 0.5 / 180.0 * M_PI) : askedWidth_rad_(width_rad) {}

  /** Makes the tables for the frame's camera. @return false when they were made for it already */
  bool layOut(const DepthFrame& frame);

  std::size_t size() const { return start_m_.size(); }
  /** The beam of each pixel of row v. */
  const std::uint16_t* beamRow(int v) const { return beamOf_.data() + offset(v); }
  /** Distance seen from above [m] of each pixel of row v per metre of depth. */
  const float* distanceRow(int v) const { return distancePerDepth_.data() + offset(v); }

  /** Starts `scan` over as one of these beams that say nothing: directions, heights of the view. */
  void startScan(const DepthFrame& frame, PlanarScan& scan) const;

 private:
  std::size_t offset(int v) const { return static_cast<std::size_t>(v) * columns_; }

  double askedWidth_rad_, width_rad_ = 0.0;
  double firstAngle_rad_ = 0.0;  // of beam 0 from the camera's heading
  DepthFrame::Geometry layout_{};
  std::size_t columns_ = 0;
  std::vector<std::uint16_t> beamOf_;
  std::vector<float> distancePerDepth_;
  std::vector<float> start_m_, steepest_;  // of each beam, as in PlanarScan
};

}  // namespace bslnav
