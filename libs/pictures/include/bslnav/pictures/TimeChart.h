#pragma once

#include <bslnav/pictures/Picture.h>
#include <bslnav/pictures/PictureStyle.h>

#include <optional>
#include <string>
#include <vector>

namespace bslnav {

/** How one series of a chart is drawn. */
struct SeriesStyle {
  enum class Form {
    Line,   ///< straight from value to value
    Steps,  ///< a value holds until the next one: commands, counts
    Points
  };
  Form form = Form::Line;
  std::optional<Colour> colour{};  ///< none: the panel's next colour
  double width_px = 2.5;
  bool dashed = false;
};

/** Charts over one axis (time or distance), stacked as panels for reports.
 *
 * Values that are not finite leave a gap. Ranges follow the data. A label is a legend entry, ""
 * draws without one. Texts are ASCII and bring their units: "speed [m/s]". */
class TimeChart {
 public:
  TimeChart(std::string title, std::string subtitle, std::string xLabel, int width_px = 1400,
            int panelHeight_px = 220);

  /** Begins a panel below the others; what follows is drawn in it. */
  void panel(const std::string& yLabel);
  /** @throws Error (Run) when no panel was begun, or unless there is one y for each x */
  void series(const std::string& label, const std::vector<double>& x, const std::vector<double>& y,
              const SeriesStyle& style = {});
  /** A shaded interval of x over the panel's height: standing, guard binding. @throws Error (Run)
   * without a panel */
  void span(double xFrom, double xTo, Colour colour, const std::string& label);
  /** A dashed horizontal line: a limit, a deadline. @throws Error (Run) without a panel */
  void limit(double y, Colour colour, const std::string& label);
  /** A dashed vertical line through all panels, with its text at the top. */
  void event(double x, const std::string& text);

  Picture finished() const;
  /** Writes a PNG. @throws Error (Run) when it cannot */
  void save(const std::string& path) const { finished().save(path); }

 private:
  friend class PictureChartPage;
  struct Series {
    std::string label;
    std::vector<double> x, y;
    SeriesStyle::Form form;
    LineStyle line;
  };
  struct Span {
    double from, to;
    Colour colour;
    std::string label;
  };
  struct Limit {
    double y;
    Colour colour;
    std::string label;
  };
  struct Panel {
    std::string yLabel;
    std::vector<Series> series;
    std::vector<Span> spans;
    std::vector<Limit> limits;
  };
  struct Event {
    double x;
    std::string text;
  };
  Panel& current();

  std::string title_, subtitle_, xLabel_;
  int width_px_, panelHeight_px_;
  std::vector<Panel> panels_;
  std::vector<Event> events_;
};

}  // namespace bslnav
