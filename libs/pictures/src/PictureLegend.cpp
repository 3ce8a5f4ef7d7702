#include "PictureLegend.h"

#include <algorithm>
#include <cmath>

#include "PictureTicks.h"

namespace bslnav {
namespace {

constexpr double kSwatchWidth = 34.0, kSwatchGap = 10.0, kColumnGap = 30.0, kRowHeight = 27.0;
constexpr double kBarWidth = 240.0, kBarThickness = 16.0, kBarHeight = 70.0, kBarGap = 12.0;
constexpr double kLongestLabel = 420.0;
const TextStyle kLabel{13.0, palette::kInk, false, false};
const TextStyle kTick{13.0, palette::kFaintInk, false, false};

}  // namespace

void PictureLegend::add(const std::string& label, Swatch swatch) {
  const auto same = [&label](const Entry& entry) { return entry.label == label; };
  if (label.empty() || std::any_of(entries_.begin(), entries_.end(), same)) return;
  entries_.push_back({label, std::move(swatch)});
}

void PictureLegend::addBar(const std::string& title, ColourMap map, double lowest, double highest) {
  for (const Bar& bar : bars_)
    if (bar.title == title && bar.lowest == lowest && bar.highest == highest) return;
  bars_.push_back({title, map, lowest, highest});
}

double PictureLegend::entryWidth() const {
  double widest = 0.0;
  for (const Entry& entry : entries_)
    widest = std::max(widest, PictureCanvas::textWidth(entry.label, kLabel));
  return kSwatchWidth + kSwatchGap + std::min(widest, kLongestLabel);
}

double PictureLegend::columnWidth() const {
  return std::max(entries_.empty() ? 0.0 : entryWidth(), bars_.empty() ? 0.0 : kBarWidth);
}

bool PictureLegend::barsBeside(double width) const {
  return !entries_.empty() && width - barsWidth() >= 2.0 * entryWidth() + 2.0 * kColumnGap;
}

double PictureLegend::barsWidth() const {
  return static_cast<double>(bars_.size()) * (kBarWidth + kColumnGap) - kColumnGap;
}

PictureLegend::Grid PictureLegend::entryGrid(double width) const {
  if (entries_.empty()) return {1, 0, 0.0};
  if (!bars_.empty() && barsBeside(width)) width -= barsWidth() + kColumnGap;
  const int count = static_cast<int>(entries_.size());
  const int fitting = static_cast<int>((width + kColumnGap) / (entryWidth() + kColumnGap));
  const int rows = (count - 1) / std::clamp(fitting, 1, count) + 1;
  const int columns = (count - 1) / rows + 1;  // evenly filled
  return {columns, rows, columns * (entryWidth() + kColumnGap) - kColumnGap};
}

PictureLegend::Grid PictureLegend::barGrid(double width) const {
  const int count = static_cast<int>(bars_.size());
  if (count == 0) return {1, 0, 0.0};
  const int fitting = static_cast<int>((width + kColumnGap) / (kBarWidth + kColumnGap));
  const int columns = barsBeside(width) ? count : std::clamp(fitting, 1, count);
  return {columns, (count - 1) / columns + 1, columns * (kBarWidth + kColumnGap) - kColumnGap};
}

double PictureLegend::usedWidth(double width) const {
  const Grid entries = entryGrid(width), bars = barGrid(width);
  if (bars.rows == 0 || !barsBeside(width)) return std::max(entries.width, bars.width);
  return entries.width + kColumnGap + bars.width;
}

double PictureLegend::height(double width) const {
  const double entries = entryGrid(width).rows * kRowHeight;
  const double bars = barGrid(width).rows * kBarHeight;
  if (barsBeside(width)) return std::max(entries, bars);
  return entries + bars + (entries > 0.0 && bars > 0.0 ? kBarGap : 0.0);
}

void PictureLegend::draw(PictureCanvas& canvas, const PagePoint& topLeft, double width) const {
  const Grid grid = entryGrid(width), bars = barGrid(width);
  for (int i = 0; i < static_cast<int>(entries_.size()); ++i) {
    const Entry& entry = entries_[static_cast<std::size_t>(i)];
    const int row = i / grid.columns, column = i % grid.columns;
    const double x = topLeft.x + column * (entryWidth() + kColumnGap);
    const double y = topLeft.y + (row + 0.5) * kRowHeight;
    entry.swatch(canvas, {x + kSwatchWidth / 2.0, y});
    canvas.text({x + kSwatchWidth + kSwatchGap, y + kLabel.capHeight_px / 2.0},
                elided(entry.label, kLabel, kLongestLabel), kLabel);
  }
  const double below = grid.rows > 0 ? grid.rows * kRowHeight + kBarGap : 0.0;
  const PagePoint first = topLeft + (barsBeside(width) ? PagePoint(grid.width + kColumnGap, 0.0)
                                                       : PagePoint(0.0, below));
  for (int i = 0; i < static_cast<int>(bars_.size()); ++i) {
    const int row = i / bars.columns, column = i % bars.columns;
    drawBar(canvas, bars_[static_cast<std::size_t>(i)],
            {first.x + column * (kBarWidth + kColumnGap), first.y + row * kBarHeight});
  }
}

void PictureLegend::drawBar(PictureCanvas& canvas, const Bar& bar, const PagePoint& topLeft) {
  canvas.text({topLeft.x, topLeft.y + 16.0}, elided(bar.title, kLabel, kBarWidth), kLabel);
  const double y = topLeft.y + 24.0;
  for (int x = 0; x < static_cast<int>(kBarWidth); ++x)
    canvas.rectangle(topLeft.x + x, y, 1.0, kBarThickness,
                     {colourAt(bar.map, (x + 0.5) / kBarWidth), 1.0, 0.0});
  canvas.rectangle(topLeft.x, y, kBarWidth, kBarThickness, {palette::kFrame, 0.0, 1.0});
  const double span = bar.highest - bar.lowest;
  if (!(span > 0.0)) return;
  const double step = niceStep(span / 4.0);
  for (const double value : ticksBetween(bar.lowest, bar.highest, step)) {
    const double x = topLeft.x + kBarWidth * (value - bar.lowest) / span;
    canvas.line({x, y + kBarThickness}, {x, y + kBarThickness + 4.0},
                {palette::kFrame, 1.0, false});
    canvas.text({x, y + kBarThickness + 21.0}, tickText(value, step), kTick, TextAlign::Centre);
  }
}

PictureLegend::Swatch lineSwatch(const LineStyle& style) {
  return [style](PictureCanvas& canvas, const PagePoint& c) {
    canvas.line({c.x - 16.0, c.y}, {c.x + 16.0, c.y}, style);
  };
}

PictureLegend::Swatch fillSwatch(const FillStyle& style) {
  return [style](PictureCanvas& canvas, const PagePoint& c) {
    canvas.rectangle(c.x - 15.0, c.y - 8.0, 30.0, 16.0, style);
  };
}

PictureLegend::Swatch gradientSwatch(ColourMap map) {
  return [map](PictureCanvas& canvas, const PagePoint& c) {
    for (int i = 0; i < 8; ++i)
      canvas.line({c.x - 16.0 + 4.0 * i, c.y}, {c.x - 12.0 + 4.0 * i, c.y},
                  {colourAt(map, (i + 0.5) / 8.0), 4.5, false});
  };
}

}  // namespace bslnav
