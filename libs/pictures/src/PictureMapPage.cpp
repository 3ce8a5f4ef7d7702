#include "PictureMapPage.h"

#include <bslnav/config/Error.h>

#include <algorithm>
#include <cmath>

#include "PictureTicks.h"

namespace bslnav {
namespace {

constexpr int kMargin = 28, kLeftAxis = 92, kBottomAxis = 62, kLegendPad = 20, kLegendColumn = 310;
constexpr double kSmallestSide = 160.0, kWideAspect = 1.25;
const TextStyle kTick{13.0, palette::kFaintInk, false, false};
const TextStyle kAxis{13.5, palette::kInk, false, false};

/** Grows an interval around its middle to `length`. */
void growTo(double& lowest, double& highest, double length) {
  const double missing = std::max(0.0, length - (highest - lowest));
  lowest -= missing / 2.0;
  highest += missing / 2.0;
}

MapBounds checked(const MapBounds& b, const std::string& title) {
  const bool good = std::isfinite(b.xMax_m - b.xMin_m) && std::isfinite(b.yMax_m - b.yMin_m) &&
                    b.xMax_m > b.xMin_m && b.yMax_m > b.yMin_m;
  if (!good)
    throw Error("picture \"" + title + "\"", "expected finite bounds with min < max",
                Error::Kind::Run);
  return b;
}

}  // namespace

PictureMapLayout::PictureMapLayout(const MapBounds& wanted, const MapPictureOptions& options)
    : margin(options.axes ? kMargin : 1),
      leftAxis(options.axes ? kLeftAxis : 0),
      bottomAxis(options.axes ? kBottomAxis : 0),
      bounds(wanted) {
  const double x_m = bounds.xMax_m - bounds.xMin_m, y_m = bounds.yMax_m - bounds.yMin_m;
  legendBelow = x_m / y_m >= kWideAspect;
  const int beside = options.legend && !legendBelow ? kLegendColumn : 0;
  const double room =
      std::max(kSmallestSide, double(options.maxWidth_px - 2 * margin - leftAxis - beside));
  const double roomUp = std::max(kSmallestSide, double(options.maxDataHeight_px));
  scale_pxpm = std::min(room / x_m, roomUp / y_m);
  growTo(bounds.xMin_m, bounds.xMax_m, kSmallestSide / scale_pxpm);
  growTo(bounds.yMin_m, bounds.yMax_m, kSmallestSide / scale_pxpm);
  width = static_cast<int>(std::ceil((bounds.xMax_m - bounds.xMin_m) * scale_pxpm - 1e-6));
  height = static_cast<int>(std::ceil((bounds.yMax_m - bounds.yMin_m) * scale_pxpm - 1e-6));
}

MapPicture::Page::Page(const std::string& title, const std::string& subtitle,
                       const MapBounds& bounds, const MapPictureOptions& options)
    : layout(checked(bounds, title), options),
      heading(title, subtitle, layout.leftAxis + layout.width),
      data(layout.width, layout.height),
      withLegend(options.legend),
      withAxes(options.axes) {
  drawGrid();
}

PagePoint MapPicture::Page::origin() const {
  return {double(layout.margin + layout.leftAxis), std::ceil(layout.margin + heading.height())};
}

std::vector<PagePoint> MapPicture::Page::inData(
    const std::vector<mrpt::math::TPoint2D>& points) const {
  std::vector<PagePoint> placed;
  placed.reserve(points.size());
  for (const auto& p : points) placed.push_back(layout.inData(p));
  return placed;
}

double MapPicture::Page::gridStep() const { return niceStep(60.0 / layout.scale_pxpm); }

void MapPicture::Page::drawGrid() {
  const MapBounds& b = layout.bounds;
  const LineStyle style{palette::kGrid, 1.0, false};
  for (const double x : ticksBetween(b.xMin_m, b.xMax_m, gridStep()))
    data.line(layout.inData({x, b.yMin_m}), layout.inData({x, b.yMax_m}), style);
  for (const double y : ticksBetween(b.yMin_m, b.yMax_m, gridStep()))
    data.line(layout.inData({b.xMin_m, y}), layout.inData({b.xMax_m, y}), style);
}

void MapPicture::Page::drawAxes(PictureCanvas& page) const {
  const MapBounds& b = layout.bounds;
  const LineStyle frame{palette::kFrame, 1.5, false};
  const PagePoint at = origin();
  const double bottom = at.y + layout.height;
  page.rectangle(at.x, at.y, layout.width, layout.height, {palette::kFrame, 0.0, 1.5});
  if (!withAxes) return;
  for (const double x : ticksBetween(b.xMin_m, b.xMax_m, gridStep())) {
    const double column = at.x + layout.inData({x, 0.0}).x;
    page.line({column, bottom}, {column, bottom + 6.0}, frame);
    page.text({column, bottom + 25.0}, tickText(x, gridStep()), kTick, TextAlign::Centre);
  }
  for (const double y : ticksBetween(b.yMin_m, b.yMax_m, gridStep())) {
    const double row = at.y + layout.inData({0.0, y}).y;
    page.line({at.x - 6.0, row}, {at.x, row}, frame);
    page.text({at.x - 11.0, row + kTick.capHeight_px / 2.0}, tickText(y, gridStep()), kTick,
              TextAlign::Right);
  }
  page.text({at.x + layout.width / 2.0, bottom + 52.0}, "x [m]", kAxis, TextAlign::Centre);
  page.textUpwards({at.x - kLeftAxis + 14.0, at.y + layout.height / 2.0}, "y [m]", kAxis);
}

Picture MapPicture::Page::finished() const {
  const int margin = layout.margin;
  const int left = static_cast<int>(origin().x), top = static_cast<int>(origin().y);
  int pageWidth = left + layout.width + margin;
  int pageHeight = top + layout.height + layout.bottomAxis + margin;
  const bool below = layout.legendBelow, legendShown = withLegend && !legend.empty();
  const double inner = below ? layout.width - 2.0 * kLegendPad : legend.columnWidth();
  const double legendHeight = legend.height(inner) + 2.0 * kLegendPad;
  PagePoint corner{double(left), pageHeight - 0.5 * margin};
  if (legendShown && below) pageHeight += static_cast<int>(legendHeight) + margin / 2;
  if (legendShown && !below) {
    corner = {double(pageWidth), double(top)};
    pageWidth += static_cast<int>(inner) + 2 * kLegendPad + margin;
    pageHeight = std::max(pageHeight, top + static_cast<int>(legendHeight) + margin);
  }

  PictureCanvas page(pageWidth, pageHeight);
  heading.draw(page, {double(margin), double(margin)});
  page.paste(data, left, top);
  drawAxes(page);
  if (legendShown) {
    page.rectangle(corner.x, corner.y, legend.usedWidth(inner) + 2.0 * kLegendPad, legendHeight,
                   {palette::kGrid, 0.0, 1.5});
    legend.draw(page, {corner.x + kLegendPad, corner.y + kLegendPad}, inner);
  }
  return page.finished();
}

}  // namespace bslnav
