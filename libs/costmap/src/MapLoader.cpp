#include <bslnav/config/Error.h>
#include <bslnav/costmap/MapLoader.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <filesystem>

#include "MapImage.h"

namespace bslnav {
namespace {

using mrpt::maps::COccupancyGridMap2D;

/** Lower-case extension without a final `.gz`. */
std::string extensionOf(const std::string& file) {
  std::filesystem::path path(file);
  if (path.extension() == ".gz") path = path.stem();
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/** Reads one serialised object; MRPT's streams uncompress as needed. */
template <typename Object>
Object deserialised(const std::string& file, const std::string& expected) {
  Object object;
  try {
    mrpt::io::CFileGZInputStream in(file);
    auto archive = mrpt::serialization::archiveFrom(in);
    archive >> object;
  } catch (const std::exception&) {
    throw Error(file, "empty, damaged, or not " + expected);
  }
  return object;
}

std::shared_ptr<COccupancyGridMap2D> loadGridMap(const std::string& file) {
  auto map = std::make_shared<COccupancyGridMap2D>(
      deserialised<COccupancyGridMap2D>(file, "an MRPT occupancy grid (COccupancyGridMap2D)"));
  if (map->getSizeX() == 0 || map->getSizeY() == 0) throw Error(file, "the grid has no cells");
  return map;
}

std::shared_ptr<COccupancyGridMap2D> buildFromSimpleMap(const std::string& file,
                                                        double resolution_m) {
  const auto observations =
      deserialised<mrpt::maps::CSimpleMap>(file, "an MRPT simplemap (CSimpleMap)");
  auto map = std::make_shared<COccupancyGridMap2D>(-1.0f, 1.0f, -1.0f, 1.0f,
                                                   static_cast<float>(resolution_m));
  map->loadFromSimpleMap(observations);
  if (map->isEmpty())
    throw Error(file, "no observation in it can be inserted into an occupancy grid");
  return map;
}

}  // namespace

void MapFileParameters::describe(ConfigSection& section) {
  section.number("map_resolution_m", resolution_m, {0.001, 10.0}, "m",
                 "cells of a map built from a simplemap; pixels of a map that is a plain image");
  section.number("map_origin_x_m", origin.x, {}, "m", "left edge of a map that is a plain image");
  section.number("map_origin_y_m", origin.y, {}, "m", "lower edge of a map that is a plain image");
}

std::shared_ptr<const COccupancyGridMap2D> loadMap(const std::string& file,
                                                   const MapFileParameters& parameters) {
  if (!std::filesystem::is_regular_file(file)) throw Error(file, "no such file; expected a map");
  if (!(parameters.resolution_m > 0.0)) throw Error(file, "map_resolution_m must be above 0");
  const std::string extension = extensionOf(file);
  if (extension == ".gridmap") return loadGridMap(file);
  if (extension == ".simplemap") return buildFromSimpleMap(file, parameters.resolution_m);
  if (extension == ".yaml" || extension == ".yml") return loadRosMap(file);
  for (const char* image : {".png", ".pgm", ".bmp", ".jpg", ".jpeg", ".tif", ".tiff", ".ppm"})
    if (extension == image) {
      ImageInterpretation meaning;
      meaning.resolution_m = parameters.resolution_m;
      meaning.origin = parameters.origin;
      return loadMapImage(file, meaning);
    }
  throw Error(
      file,
      "unknown kind of map; expected .gridmap, .simplemap (both also .gz), .yaml or an image");
}

}  // namespace bslnav
