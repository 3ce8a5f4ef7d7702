#include <bslnav/config/Error.h>
#include <bslnav/pictures/MapPicture.h>
#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <limits>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

MapPicture corridor() { return MapPicture("Title", "subtitle", {-1.0, -2.0, 11.0, 2.0}); }

Colour colourAtPoint(const MapPicture& picture, const TPoint2D& p) {
  const TPoint2D pixel = picture.pixelOf(p);
  return picture.finished().pixel(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
}

TEST(MapPictureContent, PolylineHasItsColourWhereItRuns) {
  MapPicture picture = corridor();
  picture.polyline({{0.0, 0.55}, {9.0, 0.55}}, {palette::kRed, 5.0, false}, "");
  EXPECT_EQ(colourAtPoint(picture, {4.33, 0.55}), palette::kRed);
  EXPECT_EQ(colourAtPoint(picture, {4.33, 0.75}), palette::kWhite);
}

TEST(MapPictureContent, DashedLineHasGaps) {
  MapPicture picture = corridor();
  picture.segment({0.0, 0.55}, {9.0, 0.55}, {palette::kGreen, 5.0, true}, "");
  const Picture page = picture.finished();
  const TPoint2D from = picture.pixelOf({0.1, 0.55}), to = picture.pixelOf({8.9, 0.55});
  int green = 0, white = 0;
  for (int x = static_cast<int>(from.x); x < static_cast<int>(to.x); ++x) {
    green += page.pixel(x, static_cast<int>(from.y)) == palette::kGreen ? 1 : 0;
    white += page.pixel(x, static_cast<int>(from.y)) == palette::kWhite ? 1 : 0;
  }
  EXPECT_GT(green, 400);  // of about 930 pixels, 15 on and 13 off less the round ends of the dashes
  EXPECT_GT(white, 150);
}

TEST(MapPictureContent, OccupancyTellsWallFreeAndUnknownApart) {
  MapPicture picture = corridor();
  mrpt::maps::COccupancyGridMap2D map(0.0F, 10.0F, -1.0F, 1.0F, 0.1F);
  map.setPos(0.05F, 0.55F, 0.0F);  // in the first column
  map.setPos(2.55F, 0.55F, 0.0F);
  map.setPos(4.55F, 0.55F, 1.0F);
  picture.occupancy(map);
  EXPECT_EQ(colourAtPoint(picture, {2.55, 0.55}), palette::kWall);
  EXPECT_EQ(colourAtPoint(picture, {4.55, 0.55}), palette::kWhite);
  EXPECT_EQ(colourAtPoint(picture, {6.55, 0.55}), palette::kUnknown);
  EXPECT_EQ(colourAtPoint(picture, {-0.05, 0.55}), palette::kUnknown) << "off the map";
}

TEST(MapPictureContent, CostsTellGradedInscribedLethalUnknownAndFreeApart) {
  MapPicture picture = corridor();
  CostGrid grid(50, 10, 0.1, 1.0, 0.0);
  const auto cellAt = [&grid](double x) -> Cost& {
    return grid.at(grid.cellX(x), grid.cellY(0.55));
  };
  cellAt(1.55) = 126;
  cellAt(2.55) = kInscribedCost;
  cellAt(3.55) = kLethalCost;
  cellAt(4.55) = kUnknownCost;
  picture.costs(grid);
  EXPECT_EQ(colourAtPoint(picture, {1.55, 0.55}), colourAt(ColourMap::CellCost, 0.5));
  EXPECT_EQ(colourAtPoint(picture, {2.55, 0.55}), palette::kInscribed);
  EXPECT_EQ(colourAtPoint(picture, {3.55, 0.55}), palette::kLethal);
  EXPECT_EQ(colourAtPoint(picture, {4.55, 0.55}), palette::kUnknown);
  EXPECT_EQ(colourAtPoint(picture, {5.55, 0.55}), palette::kWhite);
}

TEST(MapPictureContent, TrajectoryIsColouredBySpeed) {
  MapPicture picture = corridor();
  picture.trajectory({{0, 0.5}, {5, 0.5}, {10, 0.5}}, {0.0, 0.0, 0.5}, 0.5, "");
  EXPECT_EQ(colourAtPoint(picture, {2.5, 0.5}), colourAt(ColourMap::Speed, 0.0));
  // Between 0 and 0.5 m/s the second segment has its mean, half of the maximum.
  EXPECT_EQ(colourAtPoint(picture, {7.5, 0.5}), colourAt(ColourMap::Speed, 0.5));
}

TEST(MapPictureContent, TrajectoryNeedsASpeedForEachPoint) {
  MapPicture picture = corridor();
  EXPECT_THROW(picture.trajectory({{0, 0}, {1, 0}}, {0.1}, 0.5, ""), Error);
}

TEST(MapPictureContent, CheapestCandidateLiesOnTopAndRejectedOnesBelow) {
  MapPicture picture = corridor();
  const std::vector<TPoint2D> shorter{{0.0, 0.55}, {5.0, 0.55}}, line{{0.0, 0.55}, {9.0, 0.55}};
  picture.candidates({{shorter, 1.0, false}, {line, 5.0, false}, {line, 0.0, true}}, "cost");
  EXPECT_EQ(colourAtPoint(picture, {4.33, 0.55}), colourAt(ColourMap::TotalCost, 0.0));
  EXPECT_EQ(colourAtPoint(picture, {7.33, 0.55}), colourAt(ColourMap::TotalCost, 1.0));
}

TEST(MapPictureContent, DiscIsTranslucent) {
  MapPicture picture = corridor();
  picture.disc({4.55, 0.55}, 0.3, {{200, 100, 0}, 0.5, 0.0}, "");
  EXPECT_EQ(colourAtPoint(picture, {4.55, 0.55}), (Colour{228, 178, 128}));  // halfway from white
}

TEST(MapPictureContent, EmptyAndNonFiniteInputDrawsNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  MapPicture picture = corridor();
  picture.trajectory({}, {}, 0.5, "");
  picture.candidates({}, "cost");
  picture.polyline({{nan, 0.0}, {1.0, 0.55}}, {}, "");
  picture.disc({nan, 0.0}, 1.0, {}, "");
  picture.marker(MarkerKind::Stop, {0.0, nan}, "");
  MapPicture untouched = corridor();
  untouched.trajectory({}, {}, 0.5, "");  // its colour bar
  EXPECT_EQ(picture.finished().rgb, untouched.finished().rgb);
}

}  // namespace
}  // namespace bslnav
