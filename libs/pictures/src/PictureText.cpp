#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "PictureCanvas.h"

namespace bslnav {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kCapHeight = 21.0;  // of the font at scale 1

double scaleOf(const TextStyle& style) {
  return style.capHeight_px * PictureCanvas::kSupersampling / kCapHeight;
}

int strokeOf(const TextStyle& style) {
  const double regular = style.capHeight_px * PictureCanvas::kSupersampling / 11.0;
  return std::max(1, static_cast<int>(std::lround(style.bold ? 1.6 * regular : regular)));
}

cv::Size sizeOf(const std::string& text, const TextStyle& style) {
  int below = 0;
  return cv::getTextSize(text, kFont, scaleOf(style), strokeOf(style), &below);
}

void put(cv::Mat& image, const std::string& text, cv::Point at, const TextStyle& style) {
  const auto draw = [&](Colour c, int stroke) {
    const cv::Scalar colour(c.b, c.g, c.r);
    cv::putText(image, text, at, kFont, scaleOf(style), colour, stroke, cv::LINE_AA);
  };
  if (style.halo) draw(palette::kWhite, strokeOf(style) + 8);
  draw(style.colour, strokeOf(style));
}

}  // namespace

double PictureCanvas::textWidth(const std::string& text, const TextStyle& style) {
  return static_cast<double>(sizeOf(text, style).width) / kSupersampling;
}

void PictureCanvas::text(const PagePoint& at, const std::string& text, const TextStyle& style,
                         TextAlign align) {
  const double back = align == TextAlign::Left ? 0.0 : align == TextAlign::Centre ? 0.5 : 1.0;
  const double x = at.x - back * textWidth(text, style);
  put(pixels_, text,
      {static_cast<int>(std::lround(x * kSupersampling)),
       static_cast<int>(std::lround(at.y * kSupersampling))},
      style);
}

void PictureCanvas::textUpwards(const PagePoint& at, const std::string& text,
                                const TextStyle& style) {
  const int length = sizeOf(text, style).width;
  const int above = static_cast<int>(2.0 * style.capHeight_px * kSupersampling), below = above / 2;
  const int left = static_cast<int>(at.x * kSupersampling) - above;
  const int top = static_cast<int>(at.y * kSupersampling) - length / 2;
  const cv::Rect wanted(left, top, above + below, length);
  if ((wanted & cv::Rect(0, 0, pixels_.cols, pixels_.rows)) != wanted) return;
  cv::Mat place = pixels_(wanted), level;
  cv::rotate(place, level, cv::ROTATE_90_CLOCKWISE);
  put(level, text, {0, above}, style);
  cv::rotate(level, level, cv::ROTATE_90_COUNTERCLOCKWISE);
  level.copyTo(place);
}

std::vector<std::string> wrapped(const std::string& text, const TextStyle& style, double width_px) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool fits =
        !lines.empty() && PictureCanvas::textWidth(lines.back() + " " + word, style) <= width_px;
    if (fits)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

std::string elided(const std::string& text, const TextStyle& style, double width_px) {
  if (PictureCanvas::textWidth(text, style) <= width_px) return text;
  std::string shorter = text;
  while (!shorter.empty() && PictureCanvas::textWidth(shorter + "...", style) > width_px)
    shorter.pop_back();
  return shorter + "...";
}

}  // namespace bslnav
