#pragma once

#include <mrpt/math/TPoint2D.h>

#include <memory>
#include <string>

namespace mrpt::maps {
class COccupancyGridMap2D;
}

namespace bslnav {

/** How pixels become cells. */
struct ImageInterpretation {
  double resolution_m = 0.05;
  mrpt::math::TPoint2D origin{0, 0};  ///< lower left corner [m]
  bool trinary = false;  ///< whether to reduce to free, unknown and occupied by the two thresholds
  bool negate = false;   ///< whether white is occupied
  double occupiedThreshold = 0.65, freeThreshold = 0.196;
};

std::shared_ptr<mrpt::maps::COccupancyGridMap2D> loadMapImage(const std::string& file,
                                                              const ImageInterpretation& meaning);

/** ROS map_server's YAML file with the image it names. */
std::shared_ptr<mrpt::maps::COccupancyGridMap2D> loadRosMap(const std::string& file);

}  // namespace bslnav
