#include <bslnav/config/Error.h>
#include <bslnav/costmap/MapLoader.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace bslnav {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kMrptData = "/usr/share/mrpt/datasets/";

std::string write(const std::string& name, const std::string& content) {
  // A directory of this process: others write files of the same names at the same time.
  const std::string directory = testing::TempDir() + "bslnav_maps_" + std::to_string(getpid());
  std::filesystem::create_directories(directory);
  const std::string file = directory + "/bslnav_map_" + name;
  std::ofstream(file, std::ios::binary) << content;
  return file;
}

/** 3 × 2 pixels: the top row is occupied (0), unknown (150), free (254), the lower row free. */
std::string writeImage(const std::string& name = "small.pgm") {
  return write(name, std::string("P5\n3 2\n255\n") + '\x00' + '\x96' + "\xFE\xFE\xFE\xFE");
}

std::string yaml(const std::string& changed = "", const std::string& value = "") {
  const std::pair<std::string, std::string> keys[] = {
      {"image", "bslnav_map_small.pgm"}, {"resolution", "0.5"},
      {"origin", "[-1.0, 2.0, 0.0]"},    {"negate", "0"},
      {"occupied_thresh", "0.65"},       {"free_thresh", "0.196"}};
  std::string text = "# a map\n";
  for (const auto& [key, usual] : keys)
    if (key != changed)
      text += key + ": " + usual + "\n";
    else if (!value.empty())
      text += key + ": " + value + "  # changed\n";
  return text;
}

std::string problemOf(const std::string& file, const MapFileParameters& parameters = {}) {
  try {
    loadMap(file, parameters);
  } catch (const Error& error) {
    EXPECT_EQ(error.exitCode(), 2);
    return error.what();
  }
  return "no error";
}

TEST(MapLoader, RosMapHasTheImagesFirstRowAtTheTop) {
  writeImage();
  const auto map = loadMap(write("good.yaml", yaml()));
  ASSERT_EQ(map->getSizeX(), 3u);
  ASSERT_EQ(map->getSizeY(), 2u);
  EXPECT_NEAR(map->getXMin(), -1.0, 1e-6);
  EXPECT_NEAR(map->getYMax(), 3.0, 1e-6);  // 2 m + 2 pixels of 0.5 m
  EXPECT_LT(map->getPos(-0.9f, 2.9f), 0.1f);
  EXPECT_GT(map->getPos(-0.9f, 2.1f), 0.9f);
  EXPECT_NEAR(map->getPos(-0.4f, 2.9f), 0.5,
              0.02);  // (255 − 150) / 255 = 0.41, between the thresholds
}

TEST(MapLoader, NegatedRosMapHasWhiteOccupied) {
  writeImage();
  const auto map = loadMap(write("negate.yaml", yaml("negate", "1")));
  EXPECT_GT(map->getPos(-0.9f, 2.9f), 0.9f);
  EXPECT_LT(map->getPos(-0.9f, 2.1f), 0.1f);
}

TEST(MapLoader, PlainImageTakesResolutionAndOriginFromTheParameters) {
  MapFileParameters parameters;
  parameters.resolution_m = 0.25;
  parameters.origin = {1.0, -1.0};
  const auto map = loadMap(writeImage(), parameters);
  EXPECT_NEAR(map->getXMin(), 1.0, 1e-6);
  EXPECT_NEAR(map->getXMax(), 1.75, 1e-6);
  EXPECT_LT(map->getPos(1.1f, -0.6f), 0.1f);
  EXPECT_NEAR(map->getPos(1.3f, -0.6f), 150.0 / 255.0, 0.02);
}

TEST(MapLoader, GridmapOfMrptIsReadAsItIs) {
  const std::string file = kMrptData + "2006-MalagaCampus.gridmap.gz";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
  const auto map = loadMap(file);
  EXPECT_GT(map->getSizeX(), 100u);
  EXPECT_GT(map->getArea(), 1000.0);
}

TEST(MapLoader, SimplemapIsBuiltAtTheResolutionAsked) {
  const std::string file = kMrptData + "localization_demo.simplemap.gz";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
  MapFileParameters parameters;
  parameters.resolution_m = 0.1;
  const auto map = loadMap(file, parameters);
  EXPECT_FLOAT_EQ(map->getResolution(), 0.1f);
  int occupied = 0, free = 0;
  for (unsigned y = 0; y < map->getSizeY(); ++y)
    for (unsigned x = 0; x < map->getSizeX(); ++x) {
      const float p = map->getCell(static_cast<int>(x), static_cast<int>(y));
      occupied += p < 0.3f;
      free += p > 0.7f;
    }
  EXPECT_GT(occupied, 100);
  EXPECT_GT(free, 1000);
}

TEST(MapLoader, WillowMapHasWallsFloorAndUnknown) {
  const std::string file = BSLNAV_SHARED_DATA "/maps/willow-2010-02-18-0.10.yaml";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
  const auto map = loadMap(file);
  EXPECT_FLOAT_EQ(map->getResolution(), 0.1f);
  int counts[3] = {0, 0, 0};
  for (unsigned y = 0; y < map->getSizeY(); ++y)
    for (unsigned x = 0; x < map->getSizeX(); ++x) {
      const float p = map->getCell(static_cast<int>(x), static_cast<int>(y));
      ++counts[p < 0.1f ? 0 : p > 0.9f ? 1 : 2];
    }
  // Pixels counted by a script: (255 − v) / 255 > 0.65 occupied, < 0.196 free; 205 is unknown by a
  // hair (0.19608).
  EXPECT_THAT(counts, testing::ElementsAre(544, 109207, 234377));
}

TEST(MapLoader, MissingFileIsNamed) {
  EXPECT_THAT(problemOf("/nowhere/a.gridmap"), HasSubstr("/nowhere/a.gridmap"));
}

TEST(MapLoader, UnknownKindIsRefused) {
  EXPECT_THAT(problemOf(write("map.txt", "hello")), HasSubstr("unknown kind"));
}

TEST(MapLoader, MissingImageIsNamed) {
  const auto file = write("image.yaml", yaml("image", "none.pgm"));
  EXPECT_THAT(problemOf(file), HasSubstr("none.pgm"));
}

struct BadKey {
  std::string key, value;
};
class MapLoaderBadKey : public testing::TestWithParam<BadKey> {};

TEST_P(MapLoaderBadKey, IsNamedWithTheFile) {
  writeImage();
  const auto file = write("bad.yaml", yaml(GetParam().key, GetParam().value));
  EXPECT_THAT(problemOf(file),
              AllOf(HasSubstr("bad.yaml"), HasSubstr(GetParam().key), HasSubstr("expected")));
}

INSTANTIATE_TEST_SUITE_P(Keys, MapLoaderBadKey,
                         testing::Values(BadKey{"image", ""}, BadKey{"resolution", "0"},
                                         BadKey{"resolution", "-0.1"}, BadKey{"resolution", "0.1m"},
                                         BadKey{"resolution", "nan"}, BadKey{"resolution", ""},
                                         BadKey{"origin", "[0, 0]"}, BadKey{"origin", "0, 0, 0"},
                                         BadKey{"origin", "[0, 0, 0.5]"},
                                         BadKey{"origin", "[0, x, 0]"},
                                         BadKey{"origin", "[0, 0, 0, 0]"},
                                         BadKey{"negate", "maybe"}, BadKey{"occupied_thresh", "65"},
                                         BadKey{"free_thresh", "0.7"}));

TEST(MapLoader, UnknownKeyOfARosMapIsRefused) {
  writeImage();
  EXPECT_THAT(problemOf(write("key.yaml", yaml() + "resolutoin: 1\n")),
              AllOf(HasSubstr("resolutoin"), HasSubstr("line 8")));
}

TEST(MapLoader, KeyGivenTwiceIsRefused) {
  writeImage();
  EXPECT_THAT(problemOf(write("twice.yaml", yaml() + "negate: 1\n")), HasSubstr("twice"));
}

TEST(MapLoader, ModeOtherThanTrinaryIsRefused) {
  writeImage();
  EXPECT_THAT(problemOf(write("mode.yaml", yaml() + "mode: raw\n")), HasSubstr("trinary"));
}

TEST(MapLoader, ZeroResolutionOfAPlainImageIsRefused) {
  MapFileParameters parameters;
  parameters.resolution_m = 0.0;
  EXPECT_THAT(problemOf(writeImage(), parameters), HasSubstr("map_resolution_m"));
}

TEST(MapLoader, EmptyFilesAreRefused) {
  for (const char* name :
       {"empty.gridmap", "empty.gridmap.gz", "empty.simplemap", "empty.yaml", "empty.pgm"})
    EXPECT_THAT(problemOf(write(name, "")), AllOf(HasSubstr(name), HasSubstr("empty"))) << name;
}

TEST(MapLoader, GarbageIsRefused) {
  const std::string garbage(1000, 'x');
  for (const char* name : {"garbage.gridmap", "garbage.gridmap.gz", "garbage.simplemap.gz",
                           "garbage.yaml", "garbage.png"})
    EXPECT_THAT(problemOf(write(name, garbage)), HasSubstr(name)) << name;
}

TEST(MapLoader, TruncatedFilesAreRefused) {
  for (const char* name : {"2006-MalagaCampus.gridmap.gz", "localization_demo.simplemap.gz"}) {
    std::ifstream in(kMrptData + name, std::ios::binary);
    if (!in) GTEST_SKIP() << name;
    std::string half(20000, '\0');
    in.read(half.data(), static_cast<std::streamsize>(half.size()));
    EXPECT_THAT(problemOf(write(name, half)), HasSubstr("damaged")) << name;
  }
}

}  // namespace
}  // namespace bslnav
