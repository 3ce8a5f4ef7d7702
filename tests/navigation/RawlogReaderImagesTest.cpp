#include <bslnav/config/Error.h>
#include <gmock/gmock.h>
#include <mrpt/img/CImage.h>
#include <mrpt/math/CMatrixF.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "RawlogReaderLogs.h"

namespace bslnav {
namespace {

namespace fs = std::filesystem;
using mrpt::obs::CObservation3DRangeScan;
using testing::AllOf;
using testing::HasSubstr;
using testing_logs::Log;
using testing_logs::LogWriter;
using testing_logs::makeDepth;
using testing_logs::read;

/** Logs whose range images are files in the directory `bslnav_<name>_Images` beside them. */
class RawlogReaderImages : public testing::Test {
 protected:
  void TearDown() override {
    CObservation3DRangeScan::EXTERNALS_AS_TEXT(false);
    for (const auto& directory : directories_) fs::remove_all(directory);
  }

  std::string directoryOf(const std::string& name) {
    directories_.push_back(testing::TempDir() + "bslnav_" + name + "_Images");
    fs::remove_all(directories_.back());
    fs::create_directories(directories_.back());
    return directories_.back();
  }

  /** Three depth observations at 0.0, 0.1 and 0.2 s, of `depth_mm`, one more, and two more. */
  std::string threeImages(const std::string& name, std::uint16_t depth_mm = 1000) {
    const std::string directory = directoryOf(name);
    LogWriter writer(name);
    for (int i = 0; i < 3; ++i) {
      auto depth = makeDepth(0.1 * i, "CAMERA", static_cast<std::uint16_t>(depth_mm + i));
      depth.rangeImage_convertToExternalStorage("depth" + std::to_string(i) + ".x", directory);
      writer.add(depth);
    }
    return writer.close();
  }

  static void expectImages(const Log& log, std::uint16_t depth_mm) {
    ASSERT_EQ(log.frames.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& image = log.frames[i].depth.at(0)->rangeImage;
      ASSERT_EQ(image.rows(), 24);
      ASSERT_EQ(image.cols(), 32);
      EXPECT_EQ(image(0, 0), depth_mm + i);
      EXPECT_EQ(image(23, 31), depth_mm + i);
    }
    EXPECT_EQ(log.statistics.depthFrames, 3u);
    EXPECT_EQ(log.statistics.droppedDepthFrames, 0u);
  }

 private:
  std::vector<std::string> directories_;
};

TEST_F(RawlogReaderImages, AreLoadedFromTheDirectoryBesideTheLog) {
  expectImages(read(threeImages("images")), 1000);
}

TEST_F(RawlogReaderImages, AreLoadedFromTextFiles) {
  CObservation3DRangeScan::EXTERNALS_AS_TEXT(true);
  expectImages(read(threeImages("text_images")), 1000);
}

TEST_F(RawlogReaderImages, OfALogInTheWorkingDirectoryAreFound) {
  const fs::path file = threeImages("relative"), here = fs::current_path();
  fs::current_path(file.parent_path());
  const Log log = read(file.filename().string());
  fs::current_path(here);
  expectImages(log, 1000);
}

TEST_F(RawlogReaderImages, AreLoadedFromADirectoryThatSeveralLogsShare) {
  const std::string file = threeImages("shared_images");
  const std::string shared = testing::TempDir() + "bslnav_shared";
  fs::remove_all(shared);
  fs::create_directories(shared);
  fs::rename(file, shared + "/log.rawlog");
  fs::rename(testing::TempDir() + "bslnav_shared_images_Images", shared + "/Images");
  expectImages(read(shared + "/log.rawlog"), 1000);
  fs::remove_all(shared);
}

TEST_F(RawlogReaderImages, OfTwoLogsReadInTurnsAreNotMixedUp) {
  // Both name their files depth0.bin to depth2.bin.
  RawlogReader one(threeImages("one", 1000)), other(threeImages("other", 2000));
  const std::string base = mrpt::img::CImage::getImagesPathBase();
  SensorFrame frame;
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(one.next(frame));
    EXPECT_EQ(frame.depth.at(0)->rangeImage(5, 5), 1000 + i);
    ASSERT_TRUE(other.next(frame));
    EXPECT_EQ(frame.depth.at(0)->rangeImage(5, 5), 2000 + i);
  }
  EXPECT_EQ(mrpt::img::CImage::getImagesPathBase(), base);  // the host program's, not ours
}

TEST_F(RawlogReaderImages, OfOlderVersionsAreReadInMetres) {
  const std::string file = threeImages("old_images");
  mrpt::math::CMatrixF metres(24, 32);
  metres.fill(1.0f);
  metres(0, 1) = std::numeric_limits<float>::quiet_NaN();
  metres(0, 2) = 1e9f;
  mrpt::io::CFileGZOutputStream stream(testing::TempDir() + "bslnav_old_images_Images/depth1.bin");
  mrpt::serialization::archiveFrom(stream) << metres;
  stream.close();
  const Log log = read(file);
  ASSERT_EQ(log.frames.size(), 3u);
  const auto& image = log.frames[1].depth.at(0)->rangeImage;
  EXPECT_EQ(image(23, 31), 1000);
  EXPECT_EQ(image(0, 1), 0);
  EXPECT_EQ(image(0, 2), 0);
}

TEST_F(RawlogReaderImages, ThatAreMissingDropTheirObservationOnly) {
  const std::string file = threeImages("missing_image");
  const std::string missing = testing::TempDir() + "bslnav_missing_image_Images/depth1.bin";
  fs::remove(missing);
  const Log log = read(file);
  ASSERT_EQ(log.frames.size(), 2u);
  EXPECT_EQ(log.frames[1].depth.at(0)->rangeImage(0, 0), 1002);
  EXPECT_EQ(log.statistics.depthFrames, 2u);
  EXPECT_EQ(log.statistics.droppedDepthFrames, 1u);
  EXPECT_EQ(log.statistics.firstDroppedDepth, "record 1: " + missing + ": no such file");
}

TEST_F(RawlogReaderImages, ThatAreAllMissingAreAnErrorThatNamesTheFirst) {
  const std::string file = threeImages("all_missing");
  fs::remove_all(testing::TempDir() + "bslnav_all_missing_Images");
  try {
    RawlogReader reader(file);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Run);
    EXPECT_THAT(error.what(), AllOf(HasSubstr(file), HasSubstr("none of its 3 depth frames"),
                                    HasSubstr("record 0"), HasSubstr("depth0.bin: no such file")));
  }
}

TEST_F(RawlogReaderImages, ThatAreCutOrGarbageAreDropped) {
  const std::string file = threeImages("broken_images");
  const std::string directory = testing::TempDir() + "bslnav_broken_images_Images/";
  fs::resize_file(directory + "depth0.bin", fs::file_size(directory + "depth0.bin") / 2);
  for (const std::string garbage : {"this is no range image", "short", ""}) {
    std::ofstream(directory + "depth1.bin", std::ios::trunc) << garbage;
    const Log log = read(file);
    ASSERT_EQ(log.frames.size(), 1u) << garbage;
    EXPECT_EQ(log.frames[0].depth.at(0)->rangeImage(0, 0), 1002);
    EXPECT_EQ(log.statistics.droppedDepthFrames, 2u);
    EXPECT_THAT(log.statistics.firstDroppedDepth, HasSubstr("depth0.bin: is no whole range image"));
  }
}

TEST_F(RawlogReaderImages, ThatAreTextAndGarbageAreDropped) {
  CObservation3DRangeScan::EXTERNALS_AS_TEXT(true);
  const std::string file = threeImages("broken_text");
  for (const std::string garbage : {"this is no range image", "1 2 3\n4 5\n", ""}) {
    std::ofstream(testing::TempDir() + "bslnav_broken_text_Images/depth1.txt", std::ios::trunc)
        << garbage;
    EXPECT_EQ(read(file).statistics.droppedDepthFrames, 1u) << garbage;
  }
}

TEST_F(RawlogReaderImages, DoNotDependOnTheFilesOfTheirPoints) {
  const std::string directory = directoryOf("points");
  auto depth = makeDepth(0.0);
  depth.hasPoints3D = true;
  depth.resizePoints3DVectors(4);
  depth.points3D_convertToExternalStorage("points.x", directory);
  depth.rangeImage_convertToExternalStorage("depth.x", directory);
  fs::remove(directory + "/points.bin");
  const Log log = read(LogWriter("points").add(depth).close());
  ASSERT_EQ(log.frames.size(), 1u);
  EXPECT_EQ(log.frames[0].depth.at(0)->rangeImage(0, 0), 1500);
  EXPECT_FALSE(log.frames[0].depth[0]->hasPoints3D);
}

}  // namespace
}  // namespace bslnav
