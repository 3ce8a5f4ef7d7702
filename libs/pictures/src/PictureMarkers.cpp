#include "PictureCanvas.h"

namespace bslnav {
namespace {

constexpr FillStyle kHalo{palette::kWhite, 1.0, 1.5};

FillStyle solid(Colour colour) { return {colour, 1.0, 0.0}; }

void cross(PictureCanvas& canvas, const PagePoint& p, double arm, const LineStyle& style) {
  canvas.line({p.x - arm, p.y - arm}, {p.x + arm, p.y + arm}, style);
  canvas.line({p.x - arm, p.y + arm}, {p.x + arm, p.y - arm}, style);
}

}  // namespace

void drawMarker(PictureCanvas& canvas, MarkerKind kind, const PagePoint& p) {
  const auto diamond = [&p](double r) {
    return std::vector<PagePoint>{{p.x - r, p.y}, {p.x, p.y - r}, {p.x + r, p.y}, {p.x, p.y + r}};
  };
  switch (kind) {
    case MarkerKind::Start:
      canvas.disc(p, 9.0, solid(palette::kWhite));
      canvas.disc(p, 6.5, {palette::kGreen, 0.0, 3.5});
      return;
    case MarkerKind::Goal:
      canvas.disc(p, 11.0, solid(palette::kWhite));
      canvas.disc(p, 8.5, {palette::kBlue, 0.0, 2.5});
      canvas.disc(p, 4.0, solid(palette::kBlue));
      return;
    case MarkerKind::Contact:
      cross(canvas, p, 8.0, {palette::kWhite, 8.0, false});
      cross(canvas, p, 8.0, {palette::kRed, 4.5, false});
      return;
    case MarkerKind::Pedestrian:
      canvas.disc(p, 7.0, kHalo);
      canvas.disc(p, 6.5, solid(palette::kMagenta));
      return;
    case MarkerKind::BlindSpot:
      canvas.polygon(diamond(9.5), kHalo);
      canvas.polygon(diamond(8.5), solid(palette::kOrange));
      return;
    case MarkerKind::Stop:
      canvas.rectangle(p.x - 7.0, p.y - 7.0, 14.0, 14.0, kHalo);
      canvas.rectangle(p.x - 5.5, p.y - 5.5, 11.0, 11.0, solid(palette::kInk));
      return;
  }
}

}  // namespace bslnav
