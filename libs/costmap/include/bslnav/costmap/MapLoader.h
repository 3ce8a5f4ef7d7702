#pragma once

#include <bslnav/config/ConfigSection.h>
#include <mrpt/math/TPoint2D.h>

#include <memory>
#include <string>

namespace mrpt::maps {
class COccupancyGridMap2D;
}

namespace bslnav {

/** What a map file does not say itself. */
struct MapFileParameters {
  double resolution_m = 0.05;  ///< cells of a map built from a simplemap; pixels of a plain image
  mrpt::math::TPoint2D origin{0, 0};  ///< lower left corner of a plain image, map frame [m]

  void describe(ConfigSection& section);
};

/** Loads an occupancy grid; the file's extension says how:
 *
 * - `.gridmap`, `.gridmap.gz`: MRPT's serialised COccupancyGridMap2D
 * - `.simplemap`, `.simplemap.gz`: MRPT's poses and observations, inserted into a grid of
 * `resolution_m`
 * - `.yaml`: ROS map_server's description of an image (keys image, resolution, origin, negate,
 * occupied_thresh, free_thresh and mode, which must be trinary); an origin with a yaw is refused
 * - `.png`, `.pgm`, `.bmp`, `.jpg`, ...: a plain image, white free, black occupied, mid-grey
 * unknown
 *
 * The first row of an image is the map's top. MRPT rounds a map's corner to a multiple of its
 * resolution.
 * @throws Error naming the file, and the key if any, when it is missing, empty, damaged or not what
 * it should be */
std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> loadMap(
    const std::string& file, const MapFileParameters& parameters = {});

}  // namespace bslnav
