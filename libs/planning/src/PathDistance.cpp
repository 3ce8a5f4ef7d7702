#include <bslnav/planning/PathDistance.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bslnav {

using mrpt::math::TPoint2D;

std::size_t nearestIndex(const std::vector<TPoint2D>& path, const TPoint2D& p, std::size_t from) {
  const auto nearer = [&p](const TPoint2D& a, const TPoint2D& b) {
    return (a - p).sqrNorm() < (b - p).sqrNorm();
  };
  const auto first = path.begin() + static_cast<std::ptrdiff_t>(std::min(from, path.size() - 1));
  return static_cast<std::size_t>(std::min_element(first, path.end(), nearer) - path.begin());
}

TPoint2D pointAhead(const std::vector<TPoint2D>& path, const TPoint2D& p, double ahead_m) {
  double left = ahead_m;
  for (std::size_t i = nearestIndex(path, p); i + 1 < path.size(); ++i) {
    const double length = (path[i + 1] - path[i]).norm();
    if (length >= left && length > 0.0) return path[i] + (path[i + 1] - path[i]) * (left / length);
    left -= length;
  }
  return path.back();
}

void PathDistance::addSegment(const TPoint2D& a, const TPoint2D& b) {
  const TPoint2D along = b - a;
  ax_.push_back(static_cast<float>(a.x));
  ay_.push_back(static_cast<float>(a.y));
  bx_.push_back(static_cast<float>(along.x));
  by_.push_back(static_cast<float>(along.y));
  inverseLengthSquared_.push_back(along.sqrNorm() > 0.0 ? static_cast<float>(1.0 / along.sqrNorm())
                                                        : 0.0f);
}

void PathDistance::setPath(const std::vector<TPoint2D>& path, const TPoint2D& robot,
                           double behind_m, double ahead_m, double spacing_m) {
  for (auto* values : {&ax_, &ay_, &bx_, &by_, &inverseLengthSquared_}) values->clear();
  if (path.empty()) return;
  const std::size_t nearest = nearestIndex(path, robot);
  std::size_t first = nearest;
  for (double left = behind_m; first > 0 && left > 0.0; --first)
    left -= (path[first] - path[first - 1]).norm();
  double left = ahead_m;
  std::size_t corner = first;
  for (std::size_t i = first + 1; i < path.size() && left > 0.0; ++i) {
    if (i > nearest) left -= (path[i] - path[i - 1]).norm();
    const bool last = i + 1 == path.size() || left <= 0.0;
    if (!last && (path[i] - path[corner]).norm() < spacing_m) continue;
    addSegment(path[corner], path[i]);
    corner = i;
  }
  if (ax_.empty()) addSegment(path[nearest], path[nearest]);
}

double PathDistance::operator()(const TPoint2D& p) const {
  if (ax_.empty()) return 0.0;
  const auto x = static_cast<float>(p.x), y = static_cast<float>(p.y);
  float nearest = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < ax_.size(); ++i) {
    const float px = x - ax_[i], py = y - ay_[i];
    const float along = (px * bx_[i] + py * by_[i]) * inverseLengthSquared_[i];
    const float t = std::min(1.0f, std::max(0.0f, along));
    const float ex = px - t * bx_[i], ey = py - t * by_[i];
    nearest = std::min(nearest, ex * ex + ey * ey);
  }
  return std::sqrt(static_cast<double>(nearest));
}

}  // namespace bslnav
