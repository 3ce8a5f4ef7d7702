#include "PictureChartPage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "PictureTicks.h"

namespace bslnav {
namespace {

constexpr int kMargin = 28, kLeftAxis = 64, kBottomAxis = 62, kPanelGap = 20;
constexpr double kHeaderHeight = 27.0, kEventRow = 24.0;
const TextStyle kTick{13.0, palette::kFaintInk, false, false};
const TextStyle kAxis{13.5, palette::kInk, false, false};

/** The finite values of a list widen an interval. */
void include(const std::vector<double>& values, double& lowest, double& highest) {
  for (const double v : values) {
    if (!std::isfinite(v)) continue;
    lowest = std::min(lowest, v);
    highest = std::max(highest, v);
  }
}

PictureLegend::Swatch pointSwatch(Colour colour) {
  return [colour](PictureCanvas& canvas, const PagePoint& c) {
    canvas.disc(c, 4.0, {colour, 1.0, 0.0});
  };
}

}  // namespace

PictureChartPage::PictureChartPage(const TimeChart& chart)
    : chart_(chart),
      dataWidth_(std::max(200, chart.width_px_ - 2 * kMargin - kLeftAxis)),
      heading_(chart.title_, chart.subtitle_, dataWidth_ + kLeftAxis),
      x_(xRange()),
      xStep_(niceStep((x_.highest - x_.lowest) * 80.0 / dataWidth_)) {
  double row = kMargin + heading_.height() + (chart.events_.empty() ? 0.0 : kEventRow);
  for (const auto& panel : chart.panels_) place(panel, row);
  height_ = static_cast<int>(row) + kBottomAxis + kMargin - kPanelGap;
}

PictureChartPage::Interval PictureChartPage::xRange() const {
  double lowest = std::numeric_limits<double>::max(), highest = -lowest;
  for (const auto& panel : chart_.panels_)
    for (const auto& series : panel.series) include(series.x, lowest, highest);
  if (lowest > highest) return {};
  if (lowest == highest) return {lowest - 0.5, highest + 0.5};
  return {lowest, highest};
}

PictureChartPage::Interval PictureChartPage::yRange(const TimeChart::Panel& panel, double& step) {
  double lowest = std::numeric_limits<double>::max(), highest = -lowest;
  for (const auto& series : panel.series) include(series.y, lowest, highest);
  for (const auto& limit : panel.limits) include({limit.y}, lowest, highest);
  if (lowest > highest) lowest = 0.0, highest = 1.0;
  if (lowest > 0.0 && lowest < 0.5 * highest) lowest = 0.0;
  if (lowest == highest) {
    const double around = std::max(0.5, 0.1 * std::abs(lowest));
    lowest -= around, highest += around;
  }
  step = niceStep((highest - lowest) / 5.0);
  lowest = std::floor(lowest / step + 1e-6) * step;
  highest = std::ceil(highest / step - 1e-6) * step;
  const double edge = 0.03 * (highest - lowest);  // keeps lines at the ends clear of the frame
  return {lowest - edge, highest + edge};
}

PictureLegend PictureChartPage::legendOf(const TimeChart::Panel& panel) {
  PictureLegend legend;
  for (const auto& series : panel.series)
    legend.add(series.label, series.form == SeriesStyle::Form::Points
                                 ? pointSwatch(series.line.colour)
                                 : lineSwatch(series.line));
  for (const auto& limit : panel.limits)
    legend.add(limit.label, lineSwatch({limit.colour, 1.5, true}));
  for (const auto& span : panel.spans) legend.add(span.label, fillSwatch({span.colour, 0.2, 0.0}));
  return legend;
}

void PictureChartPage::place(const TimeChart::Panel& panel, double& row) {
  double step = 1.0;
  const Interval y = yRange(panel, step);
  PictureLegend legend = legendOf(panel);
  const double room = dataWidth_ - PictureCanvas::textWidth(panel.yLabel, kAxis) - 40.0;
  const double header = std::max(kHeaderHeight, legend.empty() ? 0.0 : legend.height(room)) + 8.0;
  const double top = std::ceil(row + header);
  panels_.push_back({&panel, std::move(legend), y, step, row, top});
  row = top + chart_.panelHeight_px_ + kPanelGap;
}

PagePoint PictureChartPage::inData(const Placed& placed, double x, double y) const {
  return {x_.fraction(x) * dataWidth_, (1.0 - placed.y.fraction(y)) * chart_.panelHeight_px_};
}

void PictureChartPage::drawSeries(PictureCanvas& data, const Placed& placed,
                                  const TimeChart::Series& series) const {
  std::vector<PagePoint> line;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const PagePoint p = inData(placed, series.x[i], series.y[i]);
    if (series.form == SeriesStyle::Form::Points) {
      if (std::isfinite(p.x) && std::isfinite(p.y))
        data.disc(p, 1.4 * series.line.width_px, {series.line.colour, 1.0, 0.0});
      continue;
    }
    if (series.form == SeriesStyle::Form::Steps && !line.empty())
      line.emplace_back(p.x, line.back().y);
    line.push_back(p);
  }
  data.polyline(line, series.line);
}

PictureCanvas PictureChartPage::drawnData(const Placed& placed) const {
  PictureCanvas data(dataWidth_, chart_.panelHeight_px_);
  const LineStyle grid{palette::kGrid, 1.0, false};
  const double bottom = chart_.panelHeight_px_;
  for (const auto& span : placed.panel->spans) {
    const double from = inData(placed, span.from, 0.0).x, to = inData(placed, span.to, 0.0).x;
    data.rectangle(from, 0.0, to - from, bottom, {span.colour, 0.2, 0.0});
  }
  for (const double x : ticksBetween(x_.lowest, x_.highest, xStep_))
    data.line({inData(placed, x, 0.0).x, 0.0}, {inData(placed, x, 0.0).x, bottom}, grid);
  for (const double y : ticksBetween(placed.y.lowest, placed.y.highest, placed.yStep))
    data.line({0.0, inData(placed, 0.0, y).y}, {double(dataWidth_), inData(placed, 0.0, y).y},
              grid);
  for (const auto& limit : placed.panel->limits) {
    const double row = inData(placed, 0.0, limit.y).y;
    data.line({0.0, row}, {double(dataWidth_), row}, {limit.colour, 1.5, true});
  }
  for (const auto& series : placed.panel->series) drawSeries(data, placed, series);
  return data;
}

void PictureChartPage::drawFrame(PictureCanvas& page, const Placed& placed, bool last) const {
  const double left = kMargin + kLeftAxis, top = placed.top, bottom = top + chart_.panelHeight_px_;
  const LineStyle frame{palette::kFrame, 1.5, false};
  page.rectangle(left, top, dataWidth_, chart_.panelHeight_px_, {palette::kFrame, 0.0, 1.5});
  for (const double y : ticksBetween(placed.y.lowest, placed.y.highest, placed.yStep)) {
    const double row = top + inData(placed, 0.0, y).y;
    page.line({left - 6.0, row}, {left, row}, frame);
    page.text({left - 11.0, row + kTick.capHeight_px / 2.0}, tickText(y, placed.yStep), kTick,
              TextAlign::Right);
  }
  for (const double x : ticksBetween(x_.lowest, x_.highest, xStep_)) {
    const double column = left + inData(placed, x, 0.0).x;
    page.line({column, bottom}, {column, bottom + 6.0}, frame);
    if (last) page.text({column, bottom + 25.0}, tickText(x, xStep_), kTick, TextAlign::Centre);
  }
  page.text({left, placed.top - 15.0}, placed.panel->yLabel, kAxis);
  if (last)
    page.text({left + dataWidth_ / 2.0, bottom + 52.0}, chart_.xLabel_, kAxis, TextAlign::Centre);
  if (placed.legend.empty()) return;
  const double room = dataWidth_ - PictureCanvas::textWidth(placed.panel->yLabel, kAxis) - 40.0;
  placed.legend.draw(page, {left + dataWidth_ - placed.legend.usedWidth(room), placed.headerTop},
                     room);
}

void PictureChartPage::drawEvents(PictureCanvas& page) const {
  for (const auto& event : chart_.events_) {
    const double fraction = x_.fraction(event.x);
    if (!(fraction >= 0.0 && fraction <= 1.0)) continue;
    const double column = kMargin + kLeftAxis + fraction * dataWidth_;
    for (const Placed& placed : panels_)
      page.line({column, placed.top}, {column, placed.top + chart_.panelHeight_px_},
                {palette::kFaintInk, 1.5, true});
    page.text({column, kMargin + heading_.height() + 10.0}, event.text, kTick,
              fraction > 0.9 ? TextAlign::Right : TextAlign::Centre);
  }
}

Picture PictureChartPage::finished() const {
  PictureCanvas page(dataWidth_ + 2 * kMargin + kLeftAxis, height_);
  heading_.draw(page, {double(kMargin), double(kMargin)});
  for (const Placed& placed : panels_)
    page.paste(drawnData(placed), kMargin + kLeftAxis, static_cast<int>(placed.top));
  for (std::size_t i = 0; i < panels_.size(); ++i)
    drawFrame(page, panels_[i], i + 1 == panels_.size());
  drawEvents(page);
  return page.finished();
}

}  // namespace bslnav
