// The cell maps of a MapPicture: occupancy and costs.
#include <bslnav/pictures/MapPicture.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <optional>

#include "PictureMapPage.h"

namespace bslnav {
namespace {

constexpr float kSurelyOccupied = 0.45F,
                kSurelyFree = 0.55F;  // MRPT cells hold the probability of being free

/** Colours every pixel of the data area for which `colourOf(x_m, y_m)` has a colour. */
template <typename ColourOf>
void paint(PictureCanvas& data, const PictureMapLayout& layout, const ColourOf& colourOf) {
  const double size_m = 1.0 / (layout.scale_pxpm * PictureCanvas::kSupersampling);
  auto& pixels = data.pixels();
  for (int row = 0; row < pixels.rows; ++row) {
    const double y_m = layout.bounds.yMax_m - (row + 0.5) * size_m;
    for (int column = 0; column < pixels.cols; ++column) {
      const std::optional<Colour> c = colourOf(layout.bounds.xMin_m + (column + 0.5) * size_m, y_m);
      if (c) pixels(row, column) = cv::Vec3b(c->b, c->g, c->r);
    }
  }
}

PictureLegend::Swatch areaSwatch(Colour colour) { return fillSwatch({colour, 1.0, 0.0}); }

}  // namespace

void MapPicture::occupancy(const mrpt::maps::COccupancyGridMap2D& map) {
  bool walls = false, unknown = false;
  paint(page_->data, page_->layout, [&](double x, double y) -> std::optional<Colour> {
    // MRPT's cell indices round towards zero, which would repeat the first row and column outside
    // the map.
    const bool outside = x < map.getXMin() || y < map.getYMin();
    const float free = outside ? 0.5F : map.getPos(static_cast<float>(x), static_cast<float>(y));
    if (free > kSurelyFree) return std::nullopt;
    const bool wall = free < kSurelyOccupied;
    (wall ? walls : unknown) = true;
    return wall ? palette::kWall : palette::kUnknown;
  });
  if (walls) page_->legend.add("wall", areaSwatch(palette::kWall));
  if (unknown) page_->legend.add("unknown", areaSwatch(palette::kUnknown));
}

void MapPicture::costs(const CostGrid& grid) {
  bool inscribed = false, lethal = false, unknown = false;
  paint(page_->data, page_->layout, [&](double x, double y) -> std::optional<Colour> {
    const int cellX = grid.cellX(x), cellY = grid.cellY(y);
    if (!grid.bounds().contains(cellX, cellY)) return std::nullopt;
    const Cost cost = grid.at(cellX, cellY);
    switch (cost) {
      case kFreeCost:
        return std::nullopt;
      case kInscribedCost:
        inscribed = true;
        return palette::kInscribed;
      case kLethalCost:
        lethal = true;
        return palette::kLethal;
      case kUnknownCost:
        unknown = true;
        return palette::kUnknown;
      default:
        return colourAt(ColourMap::CellCost, double(cost) / kHighestGradedCost);
    }
  });
  if (inscribed) page_->legend.add("inscribed", areaSwatch(palette::kInscribed));
  if (lethal) page_->legend.add("lethal", areaSwatch(palette::kLethal));
  if (unknown) page_->legend.add("unknown", areaSwatch(palette::kUnknown));
  page_->legend.addBar("cost", ColourMap::CellCost, 0.0, kHighestGradedCost);
}

}  // namespace bslnav
