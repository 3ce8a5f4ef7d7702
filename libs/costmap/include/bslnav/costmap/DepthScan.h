#pragma once

#include <bslnav/config/ConfigSection.h>
#include <bslnav/costmap/DepthBeams.h>

#include <vector>

namespace bslnav {

/** Which depth points are obstacles. */
struct DepthScanParameters {
  double zMin_m = 0.1;                        ///< above the floor and its noise
  double zMax_m = 1.0;                        ///< height of the robot
  double beamWidth_rad = 0.5 / 180.0 * M_PI;  ///< at least a pixel's width

  void describe(ConfigSection& section);
};

/** Makes a horizontal scan of a depth image: in each direction from the camera the nearest point
 * that the robot would run into, whatever its height.
 *
 * A point counts only together with the one above it in the image, so that no single pixel makes an
 * obstacle. A direction without obstacle is free as far as points were measured there, usually of
 * the floor. One object for one camera: it keeps a table of the image's directions. */
class DepthScan {
 public:
  explicit DepthScan(const DepthScanParameters& parameters = {})
      : parameters_(parameters), beams_(parameters.beamWidth_rad) {}

  /** @param frame of status Ok. The scan is valid until the next call; no allocation while the
   * camera stays the same. */
  const PlanarScan& make(const DepthFrame& frame);

 private:
  struct Direction {  // of one beam, while an image is read
    float nearest_m, farthest_m, top_m;
  };

  void readRow(const DepthFrame& frame, int v);
  void takeRow(int columns, int v);

  DepthScanParameters parameters_;
  PlanarScan scan_;
  DepthBeams beams_;
  std::vector<float> obstacle_m_, above_m_, floor_m_, height_m_;  // of a row of pixels
  std::vector<Direction> directions_;
};

}  // namespace bslnav
