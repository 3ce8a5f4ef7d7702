#include "PictureCanvas.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace bslnav {
namespace {

constexpr int kShift = 4;  // OpenCV draws at 1/16 pixel
constexpr double kPi = 3.14159265358979323846;

cv::Scalar bgr(Colour c) { return {double(c.b), double(c.g), double(c.r)}; }

// Far off the page is as good as very far: keeps OpenCV's fixed-point coordinates from overflowing.
cv::Point fixedPoint(const PagePoint& p) {
  const auto convert = [](double v) {
    const double pixel = std::clamp(v, -30000.0, 30000.0) * PictureCanvas::kSupersampling - 0.5;
    return static_cast<int>(std::lround(pixel * (1 << kShift)));
  };
  return {convert(p.x), convert(p.y)};
}

bool isFinite(const PagePoint& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

int thickness(double width_px) {
  return std::max(1, static_cast<int>(std::lround(width_px * PictureCanvas::kSupersampling)));
}

}  // namespace

PictureCanvas::PictureCanvas(int width, int height)
    : pixels_(height * kSupersampling, width * kSupersampling, cv::Vec3b(255, 255, 255)) {}

void PictureCanvas::polyline(const std::vector<PagePoint>& points, const LineStyle& style) {
  if (style.dashed) return dashed(points, style);
  for (std::size_t i = 1; i < points.size(); ++i)
    if (isFinite(points[i - 1]) && isFinite(points[i]))
      cv::line(pixels_, fixedPoint(points[i - 1]), fixedPoint(points[i]), bgr(style.colour),
               thickness(style.width_px), cv::LINE_AA, kShift);
}

void PictureCanvas::dashed(const std::vector<PagePoint>& points, const LineStyle& style) {
  const double on = 5.0 + 2.0 * style.width_px, off = 3.0 + 2.0 * style.width_px;
  const LineStyle solid{style.colour, style.width_px, false};
  double phase = 0.0;  // how far into the pattern; goes on around corners
  for (std::size_t i = 1; i < points.size(); ++i) {
    const PagePoint a = points[i - 1], step = points[i] - points[i - 1];
    const double length = step.norm();
    if (!(length > 0.0) || length > 1e5) continue;
    for (double s = 0.0; s < length;) {
      const bool drawing = phase < on;
      const double piece = std::min(length - s, (drawing ? on : on + off) - phase);
      if (drawing) line(a + step * (s / length), a + step * ((s + piece) / length), solid);
      s += piece + 1e-9;
      phase = std::fmod(phase + piece + 1e-9, on + off);
    }
  }
}

void PictureCanvas::fill(const std::vector<PagePoint>& corners, Colour colour, double opacity) {
  if (corners.size() < 3 || !std::all_of(corners.begin(), corners.end(), isFinite)) return;
  std::vector<cv::Point> outline(corners.size());
  std::transform(corners.begin(), corners.end(), outline.begin(), fixedPoint);
  cv::Rect box = cv::boundingRect(outline);
  box = cv::Rect(cv::Point(box.x >> kShift, box.y >> kShift) - cv::Point(1, 1),
                 cv::Point(box.br().x >> kShift, box.br().y >> kShift) + cv::Point(3, 3)) &
        cv::Rect(0, 0, pixels_.cols, pixels_.rows);
  if (box.empty()) return;
  for (auto& p : outline) p -= box.tl() * (1 << kShift);
  cv::Mat_<std::uint8_t> coverage(box.size(), std::uint8_t{0});
  cv::fillPoly(coverage, std::vector<std::vector<cv::Point>>{outline}, 255, cv::LINE_AA, kShift);
  const cv::Vec3b paint(colour.b, colour.g, colour.r);
  for (int y = 0; y < box.height; ++y)
    for (int x = 0; x < box.width; ++x) {
      const double alpha = opacity * coverage(y, x) / 255.0;
      cv::Vec3b& pixel = pixels_(box.y + y, box.x + x);
      for (int c = 0; c < 3; ++c)
        pixel[c] = static_cast<std::uint8_t>(std::lround(pixel[c] + (paint[c] - pixel[c]) * alpha));
    }
}

void PictureCanvas::polygon(std::vector<PagePoint> corners, const FillStyle& style) {
  if (corners.empty()) return;
  fill(corners, style.colour, style.opacity);
  corners.emplace_back(corners.front());
  if (style.outline_px > 0.0) polyline(corners, {style.colour, style.outline_px, false});
}

void PictureCanvas::disc(const PagePoint& centre, double radius, const FillStyle& style) {
  const int n = std::clamp(static_cast<int>(radius) * 2, 24, 180);
  std::vector<PagePoint> corners;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * kPi * i / n;
    corners.emplace_back(centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle));
  }
  polygon(std::move(corners), style);
}

void PictureCanvas::rectangle(double x, double y, double width, double height,
                              const FillStyle& style) {
  polygon({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, style);
}

void PictureCanvas::paste(const PictureCanvas& other, int x, int y) {
  const cv::Rect place(x * kSupersampling, y * kSupersampling, other.pixels_.cols,
                       other.pixels_.rows);
  other.pixels_.copyTo(pixels_(place));
}

void PictureCanvas::paste(const Picture& picture, int x, int y) {
  const cv::Mat source(picture.height, picture.width, CV_8UC3,
                       const_cast<std::uint8_t*>(picture.rgb.data()));
  cv::Mat swapped, enlarged;
  cv::cvtColor(source, swapped, cv::COLOR_RGB2BGR);
  cv::resize(swapped, enlarged, {}, kSupersampling, kSupersampling, cv::INTER_NEAREST);
  enlarged.copyTo(pixels_(cv::Rect({x * kSupersampling, y * kSupersampling}, enlarged.size())));
}

Picture PictureCanvas::finished() const {
  cv::Mat reduced, rgb;
  cv::resize(pixels_, reduced, {width(), height()}, 0, 0, cv::INTER_AREA);
  cv::cvtColor(reduced, rgb, cv::COLOR_BGR2RGB);
  return {width(), height(), std::vector<std::uint8_t>(rgb.datastart, rgb.dataend)};
}

}  // namespace bslnav
