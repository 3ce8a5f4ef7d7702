#pragma once

#include <functional>
#include <string>
#include <vector>

#include "PictureCanvas.h"

namespace bslnav {

/** What was drawn: swatches with labels in a grid, and colour bars beside or below them. */
class PictureLegend {
 public:
  /** Draws a sample around a centre, within 34 × 20 pixels. */
  using Swatch = std::function<void(PictureCanvas&, const PagePoint& centre)>;

  /** An empty label, or one that is there already, adds nothing. */
  void add(const std::string& label, Swatch swatch);
  /** A bar that is there already, with the same title and range, adds nothing. */
  void addBar(const std::string& title, ColourMap map, double lowest, double highest);

  bool empty() const { return entries_.empty() && bars_.empty(); }
  /** The width that one column of entries or bars needs. */
  double columnWidth() const;
  /** What the contents take of an offered width. */
  double usedWidth(double width) const;
  double height(double width) const;
  void draw(PictureCanvas& canvas, const PagePoint& topLeft, double width) const;

 private:
  struct Entry {
    std::string label;
    Swatch swatch;
  };
  struct Bar {
    std::string title;
    ColourMap map;
    double lowest, highest;
  };
  struct Grid {
    int columns, rows;
    double width;
  };
  double entryWidth() const;
  double barsWidth() const;  ///< all in one row
  bool barsBeside(double width) const;
  Grid entryGrid(double width) const;
  Grid barGrid(double width) const;
  static void drawBar(PictureCanvas& canvas, const Bar& bar, const PagePoint& topLeft);

  std::vector<Entry> entries_;
  std::vector<Bar> bars_;
};

PictureLegend::Swatch lineSwatch(const LineStyle& style);
PictureLegend::Swatch fillSwatch(const FillStyle& style);
PictureLegend::Swatch gradientSwatch(ColourMap map);

}  // namespace bslnav
