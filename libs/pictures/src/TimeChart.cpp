#include <bslnav/config/Error.h>
#include <bslnav/pictures/TimeChart.h>

#include <array>

#include "PictureChartPage.h"

namespace bslnav {

TimeChart::TimeChart(std::string title, std::string subtitle, std::string xLabel, int width_px,
                     int panelHeight_px)
    : title_(std::move(title)),
      subtitle_(std::move(subtitle)),
      xLabel_(std::move(xLabel)),
      width_px_(width_px),
      panelHeight_px_(panelHeight_px) {}

TimeChart::Panel& TimeChart::current() {
  if (panels_.empty())
    throw Error("chart \"" + title_ + "\"", "expected a panel before its contents",
                Error::Kind::Run);
  return panels_.back();
}

void TimeChart::panel(const std::string& yLabel) { panels_.push_back({yLabel, {}, {}, {}}); }

void TimeChart::series(const std::string& label, const std::vector<double>& x,
                       const std::vector<double>& y, const SeriesStyle& style) {
  constexpr std::array<Colour, 6> kColours{palette::kBlue,    palette::kOrange, palette::kGreen,
                                           palette::kMagenta, palette::kSky,    palette::kInk};
  if (x.size() != y.size())
    throw Error("chart \"" + title_ + "\" series \"" + label + "\"", "expected one y for each x",
                Error::Kind::Run);
  Panel& panel = current();
  const Colour colour = style.colour.value_or(kColours[panel.series.size() % kColours.size()]);
  panel.series.push_back({label, x, y, style.form, {colour, style.width_px, style.dashed}});
}

void TimeChart::span(double xFrom, double xTo, Colour colour, const std::string& label) {
  current().spans.push_back({xFrom, xTo, colour, label});
}

void TimeChart::limit(double y, Colour colour, const std::string& label) {
  current().limits.push_back({y, colour, label});
}

void TimeChart::event(double x, const std::string& text) { events_.push_back({x, text}); }

Picture TimeChart::finished() const { return PictureChartPage(*this).finished(); }

}  // namespace bslnav
