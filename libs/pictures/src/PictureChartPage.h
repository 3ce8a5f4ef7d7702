#pragma once

#include <bslnav/pictures/TimeChart.h>

#include "PictureCanvas.h"
#include "PictureHeading.h"
#include "PictureLegend.h"

namespace bslnav {

/** Lays out and draws one TimeChart. */
class PictureChartPage {
 public:
  explicit PictureChartPage(const TimeChart& chart);

  Picture finished() const;

 private:
  struct Interval {
    double lowest = 0.0, highest = 1.0;
    double fraction(double v) const { return (v - lowest) / (highest - lowest); }
  };
  struct Placed {
    const TimeChart::Panel* panel;
    PictureLegend legend;
    Interval y;
    double yStep, headerTop, top;  ///< rows on the page; `top` of the data area
  };
  Interval xRange() const;
  static Interval yRange(const TimeChart::Panel& panel, double& step);
  static PictureLegend legendOf(const TimeChart::Panel& panel);
  void place(const TimeChart::Panel& panel, double& row);
  PagePoint inData(const Placed& placed, double x, double y) const;
  void drawFrame(PictureCanvas& page, const Placed& placed, bool last) const;
  PictureCanvas drawnData(const Placed& placed) const;
  void drawSeries(PictureCanvas& data, const Placed& placed, const TimeChart::Series& series) const;
  void drawEvents(PictureCanvas& page) const;

  const TimeChart& chart_;
  int dataWidth_;
  PictureHeading heading_;
  Interval x_;
  double xStep_;
  std::vector<Placed> panels_;
  int height_ = 0;
};

}  // namespace bslnav
