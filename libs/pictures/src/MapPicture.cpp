#include <bslnav/config/Error.h>
#include <bslnav/pictures/MapPicture.h>

#include <algorithm>
#include <cmath>

#include "PictureMapPage.h"

namespace bslnav {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;

MapPicture::MapPicture(const std::string& title, const std::string& subtitle,
                       const MapBounds& bounds, const MapPictureOptions& options)
    : page_(std::make_unique<Page>(title, subtitle, bounds, options)) {}
MapPicture::~MapPicture() = default;
MapPicture::MapPicture(MapPicture&&) noexcept = default;
MapPicture& MapPicture::operator=(MapPicture&&) noexcept = default;

void MapPicture::trajectory(const std::vector<TPoint2D>& points,
                            const std::vector<double>& speeds_mps, double maxSpeed_mps,
                            const std::string& label) {
  if (points.size() != speeds_mps.size())
    throw Error("trajectory \"" + label + "\"", "expected one speed for each point",
                Error::Kind::Run);
  constexpr double kWidth_px = 4.5;
  const std::vector<PagePoint> placed = page_->inData(points);
  page_->data.polyline(placed, {palette::kWhite, kWidth_px + 2.5, false});
  for (std::size_t i = 1; i < placed.size(); ++i) {
    const double speed = (speeds_mps[i - 1] + speeds_mps[i]) / 2.0;
    const Colour colour = colourAt(ColourMap::Speed, speed / maxSpeed_mps);
    page_->data.line(placed[i - 1], placed[i], {colour, kWidth_px, false});
  }
  page_->legend.add(label, gradientSwatch(ColourMap::Speed));
  page_->legend.addBar("speed [m/s]", ColourMap::Speed, 0.0, maxSpeed_mps);
}

void MapPicture::polyline(const std::vector<TPoint2D>& points, const LineStyle& style,
                          const std::string& label) {
  page_->data.polyline(page_->inData(points), style);
  page_->legend.add(label, lineSwatch(style));
}

void MapPicture::segment(const TPoint2D& a, const TPoint2D& b, const LineStyle& style,
                         const std::string& label) {
  polyline({a, b}, style, label);
}

void MapPicture::candidates(const std::vector<CandidateLine>& lines, const std::string& label) {
  std::vector<const CandidateLine*> admitted;
  for (const CandidateLine& line : lines) {
    if (!line.rejected && std::isfinite(line.cost)) {
      admitted.push_back(&line);
    } else {
      polyline(line.points, {palette::kRejected, 1.0, false}, "rejected candidate");
    }
  }
  if (admitted.empty()) return;
  std::stable_sort(admitted.begin(), admitted.end(),
                   [](const auto* a, const auto* b) { return a->cost > b->cost; });
  const double highest = admitted.front()->cost, lowest = admitted.back()->cost;
  for (const CandidateLine* line : admitted) {
    const double fraction = highest > lowest ? (line->cost - lowest) / (highest - lowest) : 0.0;
    polyline(line->points, {colourAt(ColourMap::TotalCost, fraction), 1.5, false}, "");
  }
  page_->legend.addBar(label, ColourMap::TotalCost, lowest, highest);
}

void MapPicture::disc(const TPoint2D& centre, double radius_m, const FillStyle& style,
                      const std::string& label) {
  page_->data.disc(page_->layout.inData(centre), radius_m * page_->layout.scale_pxpm, style);
  page_->legend.add(label, fillSwatch(style));
}

void MapPicture::polygon(const std::vector<TPoint2D>& corners, const FillStyle& style,
                         const std::string& label) {
  page_->data.polygon(page_->inData(corners), style);
  page_->legend.add(label, fillSwatch(style));
}

void MapPicture::outline(const TPose2D& mapFromRobot, const Footprint& footprint,
                         const FillStyle& style, const std::string& label) {
  const TPoint2D centre{mapFromRobot.x, mapFromRobot.y};
  if (footprint.isCircle()) {
    disc(centre, footprint.radius_m, style, label);
  } else {
    std::vector<TPoint2D> corners;
    for (const TPoint2D& corner : footprint.polygon)
      corners.push_back(mapFromRobot.composePoint(corner));
    polygon(corners, style, label);
  }
  const TPoint2D front = mapFromRobot.composePoint({footprint.inscribedRadius_m(), 0.0});
  segment(centre, front, {style.colour, std::max(1.5, style.outline_px), false}, "");
}

void MapPicture::marker(MarkerKind kind, const TPoint2D& at, const std::string& label) {
  if (std::isfinite(at.x) && std::isfinite(at.y))
    drawMarker(page_->data, kind, page_->layout.inData(at));
  page_->legend.add(
      label, [kind](PictureCanvas& canvas, const PagePoint& c) { drawMarker(canvas, kind, c); });
}

void MapPicture::note(const TPoint2D& at, const std::string& text) {
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) return;
  const PagePoint p = page_->layout.inData(at);
  const TextStyle style{13.0, palette::kInk, false, true};
  const bool fits = p.x + 12.0 + PictureCanvas::textWidth(text, style) < page_->layout.width;
  page_->data.text({fits ? p.x + 12.0 : p.x - 12.0, p.y - 8.0}, text, style,
                   fits ? TextAlign::Left : TextAlign::Right);
}

TPoint2D MapPicture::pixelOf(const TPoint2D& p) const {
  return page_->origin() + page_->layout.inData(p);
}

Picture MapPicture::finished() const { return page_->finished(); }

Picture MapPicture::legend(int width_px) const {
  constexpr int kPad = 12;
  const double inner = width_px - 2.0 * kPad;
  PictureCanvas canvas(width_px, static_cast<int>(page_->legend.height(inner)) + 2 * kPad);
  page_->legend.draw(canvas, {double(kPad), double(kPad)}, inner);
  return canvas.finished();
}

}  // namespace bslnav
