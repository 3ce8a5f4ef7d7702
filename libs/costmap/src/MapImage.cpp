#include "MapImage.h"

#include <bslnav/config/Error.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>

namespace bslnav {
namespace {

/** Probability of being free. 0.01 and 0.99 are what MRPT's own loader of bitmaps keeps to. */
float freeProbability(double brightness, const ImageInterpretation& meaning) {
  const double free = meaning.negate ? 1.0 - brightness : brightness;
  if (!meaning.trinary) return static_cast<float>(std::clamp(free, 0.01, 0.99));
  const double occupied = 1.0 - free;
  return occupied > meaning.occupiedThreshold ? 0.01f
         : occupied < meaning.freeThreshold   ? 0.99f
                                              : 0.5f;
}

cv::Mat readGrey(const std::string& file) {
  if (!std::filesystem::is_regular_file(file))
    throw Error(file, "no such file; expected the image of a map");
  cv::Mat image;
  try {
    image = cv::imread(file, cv::IMREAD_GRAYSCALE);
  } catch (const cv::Exception& problem) {
    throw Error(file, std::string("not a readable image: ") + problem.what());
  }
  if (image.empty()) throw Error(file, "empty, damaged, or not an image");
  return image;
}

}  // namespace

std::shared_ptr<mrpt::maps::COccupancyGridMap2D> loadMapImage(const std::string& file,
                                                              const ImageInterpretation& meaning) {
  const cv::Mat image = readGrey(file);
  const double resolution_m = meaning.resolution_m;
  const double left = std::round(meaning.origin.x / resolution_m),
               bottom = std::round(meaning.origin.y / resolution_m);
  const auto metres = [resolution_m](double cells) {
    return static_cast<float>(cells * resolution_m);
  };
  auto map = std::make_shared<mrpt::maps::COccupancyGridMap2D>(
      metres(left), metres(left + image.cols), metres(bottom), metres(bottom + image.rows),
      static_cast<float>(resolution_m));
  for (int y = 0; y < image.rows; ++y) {
    const auto* pixels = image.ptr<unsigned char>(image.rows - 1 - y);
    for (int x = 0; x < image.cols; ++x)
      map->setCell(x, y, freeProbability(pixels[x] / 255.0, meaning));
  }
  return map;
}

}  // namespace bslnav
