#include <bslnav/config/Error.h>
#include <bslnav/pictures/MapPicture.h>
#include <bslnav/pictures/PictureTiles.h>
#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <cmath>
#include <fstream>
#include <iterator>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

const MapBounds kCorridor{-1.0, -2.0, 11.0, 2.0};  // 12 m x 4 m

MapPicture corridor() { return MapPicture("Title", "subtitle", kCorridor); }

/** Rows from the lower edge of the map to the end of the page that are not entirely white. */
int inkedRowsBelow(const MapPicture& picture, double yMin_m) {
  const Picture page = picture.finished();
  int rows = 0;
  for (int y = static_cast<int>(picture.pixelOf({0.0, yMin_m}).y) + 2; y < page.height; ++y) {
    bool inked = false;
    for (int x = 0; x < page.width; ++x) inked |= page.pixel(x, y) != palette::kWhite;
    rows += inked ? 1 : 0;
  }
  return rows;
}

std::string bytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

MapPicture everythingDrawn() {
  MapPicture picture = corridor();
  mrpt::maps::COccupancyGridMap2D map(-1.0F, 11.0F, -2.0F, 2.0F, 0.05F);
  map.setPos(5.0F, 1.0F, 0.0F);
  picture.occupancy(map);
  picture.costs(CostGrid(20, 20, 0.05, 3.0, 0.0, Cost{100}));
  picture.trajectory({{0, 0}, {5, 0.5}, {9, 0}}, {0.1, 0.5, 0.2}, 0.56, "path");
  picture.candidates({{{{1, 0}, {2, 1}}, 3.0, false}, {{{1, 0}, {2, -1}}, 0.0, true}}, "cost J");
  picture.disc({7, 0}, 1.0, {}, "danger zone");
  picture.outline({2.0, 0.0, 0.3}, {}, {palette::kInk, 0.2, 2.0}, "robot");
  picture.marker(MarkerKind::Contact, {8, 0}, "contact");
  picture.note({8, 0}, "0.3 m/s");
  return picture;
}

TEST(MapPicture, PageFollowsTheAspectOfTheBounds) {
  const MapPicture picture = corridor();
  const TPoint2D topLeft = picture.pixelOf({-1.0, 2.0}),
                 bottomRight = picture.pixelOf({11.0, -2.0});
  EXPECT_EQ(picture.finished().width, 1400);
  // 12 m x 4 m at equal aspect: three times as wide as high.
  EXPECT_NEAR((bottomRight.x - topLeft.x) / (bottomRight.y - topLeft.y), 3.0, 1e-9);
  // Title, subtitle, ticks and axis label take less than 250 rows; nothing else may stand around
  // the map.
  EXPECT_LT(picture.finished().height, bottomRight.y - topLeft.y + 250.0);
}

TEST(MapPicture, SavedFileIsAPngOfThePagesSize) {
  const std::string path = testing::TempDir() + "map_picture_size.png";
  const MapPicture picture = corridor();
  picture.save(path);
  const std::string png = bytesOf(path);
  ASSERT_GT(png.size(), 24U);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  // The IHDR chunk holds width and height as big-endian 32-bit numbers from byte 16.
  const auto number = [&png](std::size_t at) {
    int value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = value * 256 + static_cast<unsigned char>(png[at + i]);
    return value;
  };
  EXPECT_EQ(number(16), picture.finished().width);
  EXPECT_EQ(number(20), picture.finished().height);
}

TEST(MapPicture, LabelAddsALegendEntry) {
  MapPicture without = corridor(), with = corridor();
  without.disc({5.0, 0.0}, 1.0, {}, "");
  with.disc({5.0, 0.0}, 1.0, {}, "danger zone");
  EXPECT_GT(inkedRowsBelow(with, -2.0), inkedRowsBelow(without, -2.0) + 20);
  EXPECT_GT(with.finished().height, without.finished().height);
}

TEST(MapPicture, SameLabelTwiceIsOneLegendEntry) {
  MapPicture once = corridor(), twice = corridor();
  once.polyline({}, {}, "path");
  for (int i = 0; i < 2; ++i) twice.polyline({}, {}, "path");
  EXPECT_EQ(once.finished().rgb, twice.finished().rgb);
}

TEST(MapPicture, LegendOfATallMapStandsBesideIt) {
  MapPicture picture("", "", {0.0, 0.0, 4.0, 8.0});
  const int before = picture.finished().width;
  picture.marker(MarkerKind::Goal, {2.0, 2.0}, "goal");
  EXPECT_GT(picture.finished().width, before);
}

TEST(MapPicture, SameCallsGiveTheSameBytes) {
  const std::string first = testing::TempDir() + "map_picture_a.png";
  const std::string second = testing::TempDir() + "map_picture_b.png";
  everythingDrawn().save(first);
  everythingDrawn().save(second);
  EXPECT_FALSE(bytesOf(first).empty());
  EXPECT_EQ(bytesOf(first), bytesOf(second));
}

TEST(MapPicture, ImpossiblePathIsAnErrorOfTheRun) {
  try {
    corridor().save(testing::TempDir() + "no_such_directory/picture.png");
    FAIL() << "expected an Error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Run);
    EXPECT_NE(std::string(error.what()).find("no_such_directory/picture.png"), std::string::npos);
  }
}

TEST(MapPicture, EmptyBoundsAreRefused) {
  EXPECT_THROW(MapPicture("", "", {0.0, 0.0, 0.0, 1.0}), Error);
  EXPECT_THROW(MapPicture("", "", {0.0, 0.0, std::nan(""), 1.0}), Error);
}

TEST(MapPictureTiles, FourTilesAreTwoRowsOfTwo) {
  const Picture one{30, 20, std::vector<std::uint8_t>(30 * 20 * 3, 90)};
  const Picture page = tiled({{one, "a"}, {one, "b"}, {one, "c"}, {one, "d"}}, 2);
  // Margins of 20 around and between; a caption of 34 rows above each tile.
  EXPECT_EQ(page.width, 20 + 2 * (30 + 20));
  EXPECT_EQ(page.height, 20 + 2 * (34 + 20 + 20));
  EXPECT_EQ(page.pixel(20 + 50 + 15, 20 + 74 + 34 + 10), (Colour{90, 90, 90}));
  EXPECT_EQ(page.pixel(20 + 30 + 10, 20 + 34 + 10), palette::kWhite);
}

}  // namespace
}  // namespace bslnav
