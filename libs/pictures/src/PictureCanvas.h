#pragma once

#include <bslnav/pictures/Picture.h>
#include <bslnav/pictures/PictureStyle.h>
#include <mrpt/math/TPoint2D.h>

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace bslnav {

/** A place on a page in pixels of the finished picture: x to the right, y down, (0, 0) the top left
 * corner. */
using PagePoint = mrpt::math::TPoint2D;

struct TextStyle {
  double capHeight_px = 13.0;
  Colour colour = palette::kInk;
  bool bold = false;
  bool halo = false;  ///< white around the letters, for text over other things
};

enum class TextAlign { Left, Centre, Right };

/** A page drawn at twice its size and averaged down at the end, which smooths lines and letters
 * alike.
 *
 * Text is ASCII in OpenCV's built-in stroke font, so that a picture is the same on every machine.
 */
class PictureCanvas {
 public:
  static constexpr int kSupersampling = 2;

  PictureCanvas(int width, int height);

  int width() const { return pixels_.cols / kSupersampling; }
  int height() const { return pixels_.rows / kSupersampling; }

  /** Points that are not finite break the line; one point alone draws nothing. */
  void polyline(const std::vector<PagePoint>& points, const LineStyle& style);
  void line(const PagePoint& a, const PagePoint& b, const LineStyle& style) {
    polyline({a, b}, style);
  }
  void polygon(std::vector<PagePoint> corners, const FillStyle& style);
  void disc(const PagePoint& centre, double radius, const FillStyle& style);
  void rectangle(double x, double y, double width, double height, const FillStyle& style);

  /** @param at where the baseline begins, has its middle, or ends */
  void text(const PagePoint& at, const std::string& text, const TextStyle& style,
            TextAlign align = TextAlign::Left);
  /** Text that reads upwards. @param at the middle of its baseline */
  void textUpwards(const PagePoint& at, const std::string& text, const TextStyle& style);
  static double textWidth(const std::string& text, const TextStyle& style);

  void paste(const PictureCanvas& other, int x, int y);
  void paste(const Picture& picture, int x, int y);
  Picture finished() const;

  /** The enlarged pixels in OpenCV's order (blue, green, red). */
  cv::Mat_<cv::Vec3b>& pixels() { return pixels_; }

 private:
  void dashed(const std::vector<PagePoint>& points, const LineStyle& style);
  void fill(const std::vector<PagePoint>& corners, Colour colour, double opacity);

  cv::Mat_<cv::Vec3b> pixels_;
};

/** Breaks a text between words so that each line fits; a single word may be wider. */
std::vector<std::string> wrapped(const std::string& text, const TextStyle& style, double width_px);

/** Shortens a text with "..." at its end until it fits. */
std::string elided(const std::string& text, const TextStyle& style, double width_px);

void drawMarker(PictureCanvas& canvas, MarkerKind kind, const PagePoint& at);

}  // namespace bslnav
