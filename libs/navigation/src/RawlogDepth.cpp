#include "RawlogDepth.h"

#include <mrpt/math/CMatrixF.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <filesystem>
#include <utility>

#include "WholeReads.h"

namespace bslnav {
namespace {

using mrpt::obs::CObservation3DRangeScan;
namespace fs = std::filesystem;

/** The way to the name of the file with the range image, which MRPT lets only a subclass change. */
struct ImageFile : CObservation3DRangeScan {
  static std::string& of(CObservation3DRangeScan& depth) {
    return depth.*(&ImageFile::m_rangeImage_external_file);
  }
};

/** Older versions of MRPT wrote a matrix of metres, in some logs with swapped sizes in the
 * calibration. */
bool readMetres(CObservation3DRangeScan& depth, const std::string& file) {
  WholeReads stream;
  if (!stream.open(file)) return false;
  mrpt::math::CMatrixF metres;
  mrpt::serialization::archiveFrom(stream) >> metres;
  const auto rows = static_cast<int>(metres.rows()), columns = static_cast<int>(metres.cols());
  depth.rangeImage_setSize(rows, columns);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const float units = metres(row, column) / depth.rangeUnits;
      const bool fits = units > 0.0f && units < 65535.0f;  // NaN does not
      depth.rangeImage(row, column) = static_cast<std::uint16_t>(fits ? std::lround(units) : 0);
    }
  auto& camera = depth.cameraParams;
  if (static_cast<int>(camera.ncols) == rows && static_cast<int>(camera.nrows) == columns)
    std::swap(camera.ncols, camera.nrows);
  return true;
}

/** Reads rows, columns and pixels.
 *
 * MRPT's own load() believes any size, and takes any end of a file for the end of the image.
 *  @return false when the file holds no range image  @throws std::exception where it ends early */
bool readPixels(CObservation3DRangeScan& depth, const std::string& file) {
  constexpr std::uint32_t kMostPixels = 10000;  // in a row or column
  WholeReads stream;
  if (!stream.open(file)) return false;
  auto archive = mrpt::serialization::archiveFrom(stream);
  const auto rows = archive.ReadAs<std::uint32_t>(), columns = archive.ReadAs<std::uint32_t>();
  if (rows >> 8 == 0x614D43 || rows >> 8 == 0x70726D)  // a class name: CMa..., mrp...
    return readMetres(depth, file);
  if (rows == 0 || columns == 0 || rows > kMostPixels || columns > kMostPixels) return false;
  depth.rangeImage_setSize(static_cast<int>(rows), static_cast<int>(columns));
  archive.ReadBufferFixEndianness(depth.rangeImage.data(), depth.rangeImage.size());
  return true;
}

bool readImage(CObservation3DRangeScan& depth, const std::string& file) try {
  if (fs::path(file).extension() != ".txt") return readPixels(depth, file);
  depth.rangeImage.loadFromTextFile(file);
  return true;
} catch (const std::exception&) {  // its text is MRPT's source line and a backtrace
  return false;
}

std::string loadFromFile(CObservation3DRangeScan& depth, const std::string& imagesDirectory) {
  // MRPT looks for a relative name in one directory of the whole process; an absolute name keeps
  // logs that are read at the same time apart.
  std::string& file = ImageFile::of(depth);
  file = (fs::path(imagesDirectory) / file).string();
  if (!fs::is_regular_file(file)) return file + ": no such file";
  return readImage(depth, file) ? "" : file + ": is no whole range image";
}

}  // namespace

// CRawlog::detectImagesDirectory() of MRPT 2.5 forgets the slash after the log's directory.
std::string imagesDirectoryOf(const std::string& log) {
  const fs::path path = fs::absolute(log), directory = path.parent_path();
  for (const char* ending : {"_Images", "_images", "_IMAGES"}) {
    const fs::path images = directory / (path.stem().string() + ending);
    if (fs::is_directory(images)) return images.string();
  }
  return (directory / "Images").string();
}

void forgetPoints(CObservation3DRangeScan& depth) {
  depth.hasPoints3D = false;
  depth.resizePoints3DVectors(0);
}

std::string loadRangeImage(CObservation3DRangeScan& depth, const std::string& imagesDirectory) {
  if (!depth.hasRangeImage) return "has no range image";
  if (depth.rangeImage_isExternallyStored()) {
    const std::string problem = loadFromFile(depth, imagesDirectory);
    if (!problem.empty()) return problem;
  }
  return depth.rangeImage.size() > 0 ? "" : "has an empty range image";
}

}  // namespace bslnav
