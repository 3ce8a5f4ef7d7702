#include <bslnav/pictures/MapPicture.h>
#include <bslnav/pictures/PictureTiles.h>
#include <gtest/gtest.h>

namespace bslnav {
namespace {

/** A picture all in one colour. */
Picture filled(int width, int height, Colour c) {
  Picture picture{width, height, {}};
  for (int i = 0; i < width * height; ++i) picture.rgb.insert(picture.rgb.end(), {c.r, c.g, c.b});
  return picture;
}

TEST(Stacked, PutsPicturesBelowEachOtherInTheMiddle) {
  const Picture page =
      stacked({filled(40, 10, palette::kRed), filled(20, 6, palette::kBlue), Picture{}});
  EXPECT_EQ(page.width, 40);
  EXPECT_EQ(page.height, 16);
  EXPECT_EQ(page.pixel(0, 9), palette::kRed);
  EXPECT_EQ(page.pixel(9, 10), palette::kWhite);  // (40 - 20) / 2 = 10 columns on either side
  EXPECT_EQ(page.pixel(10, 10), palette::kBlue);
  EXPECT_EQ(page.pixel(29, 15), palette::kBlue);
  EXPECT_EQ(page.pixel(30, 15), palette::kWhite);
}

TEST(Tiled, LeavesRoomForCaptionsOnlyWhereThereAreSome) {
  const Picture tile = filled(100, 50, palette::kRed);
  // Margin 20 above, tile, margin 20 below; a caption takes 34.
  EXPECT_EQ(tiled({{tile, ""}, {tile, ""}}, 2).height, 90);
  EXPECT_EQ(tiled({{tile, ""}, {tile, "two"}}, 2).height, 124);
}

TEST(MapPictureOptions, WithoutAxesTheMapFillsThePicture) {
  const MapPicture picture("", "", {0.0, 0.0, 8.0, 4.0}, {402, 900, false, false});
  // One pixel around the data area: 400 pixels for 8 m.
  EXPECT_EQ(picture.finished().width, 402);
  EXPECT_EQ(picture.finished().height, 202);
  EXPECT_EQ(picture.pixelOf({0.0, 4.0}).x, 1.0);
  EXPECT_EQ(picture.pixelOf({0.0, 4.0}).y, 1.0);
  EXPECT_EQ(picture.pixelOf({8.0, 0.0}).x, 401.0);
}

}  // namespace
}  // namespace bslnav
