#include <bslnav/simulation/Pedestrian.h>

#include <algorithm>
#include <cmath>

#include "WayRound.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

double cross(const TPoint2D& a, const TPoint2D& b) { return a.x * b.y - a.y * b.x; }

/** Fraction of the way `from` → `to` at which the segment a–b is met; NaN when it is not. */
double crossing(const TPoint2D& from, const TPoint2D& to, const TPoint2D& a, const TPoint2D& b) {
  const TPoint2D way = to - from, line = b - a;
  const double determinant = cross(way, line);
  const double fraction = cross(a - from, line) / determinant;  // infinite or NaN when parallel
  const double alongLine = cross(a - from, way) / determinant;
  const bool meets = fraction >= 0.0 && fraction <= 1.0 && alongLine >= 0.0 && alongLine <= 1.0;
  return meets ? fraction : std::nan("");
}

}  // namespace

Pedestrian::Pedestrian(const PedestrianParameters& parameters) : parameters_(parameters) {
  measurePath();
  if (parameters_.triggerLine_m.empty()) start_s_ = parameters_.startDelay_s;
}

void Pedestrian::measurePath() {
  const auto& path = parameters_.path_m;
  pathLength_m_ = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) pathLength_m_ += (path[i] - path[i - 1]).norm();
}

void Pedestrian::observeRobot(const TPoint2D& from, double from_s, const TPoint2D& to,
                              double to_s) {
  if (std::isfinite(start_s_)) return yieldTo(to, from_s, to_s);
  const auto& line = parameters_.triggerLine_m;
  const double fraction = crossing(from, to, line[0], line[1]);
  if (!std::isnan(fraction))
    start_s_ = from_s + fraction * (to_s - from_s) + parameters_.startDelay_s;
}

void Pedestrian::yieldTo(const TPoint2D& robot, double from_s, double to_s) {
  const double within_m = parameters_.yieldsWithin_m;
  if (within_m <= 0.0) return;
  const double now_m = (position(from_s) - robot).norm(), next_m = (position(to_s) - robot).norm();
  waits_ = next_m < within_m && next_m < now_m;
  if (waits_) waited_s_ += to_s - from_s;
  waitsFor_s_ = waits_ ? waitsFor_s_ + to_s - from_s : 0.0;
}

void Pedestrian::walkRound(const TPoint2D& robot, double time_s,
                           const std::vector<WorldShape>& solids) {
  const double patience_s = parameters_.walksRoundAfter_s;
  if (patience_s <= 0.0 || waitsFor_s_ < patience_s) return;
  waitsFor_s_ = 0.0;
  const double walked = walked_m(time_s), before_m = pathLength_m_;
  auto& path = parameters_.path_m;
  const auto ahead = path.begin() + static_cast<std::ptrdiff_t>(cornerAfter(walked));
  std::vector<TPoint2D> rest{position(time_s)};
  rest.insert(rest.end(), ahead, path.end());
  const auto way = wayRound(rest, robot, parameters_.yieldsWithin_m,
                            {{}, parameters_.radius_m, parameters_.height_m}, solids);
  if (!way) return;
  path.erase(ahead, path.end());
  path.insert(path.end(), way->begin(), way->end());
  measurePath();
  if (walked < parameters_.pauseAfter_m)  // the pause stays where it is
    parameters_.pauseAfter_m += std::max(0.0, pathLength_m_ - before_m);
}

std::size_t Pedestrian::cornerAfter(double walked_m) const {
  const auto& path = parameters_.path_m;
  std::size_t next = 1;
  for (; next + 1 < path.size(); ++next) {
    const double length_m = (path[next] - path[next - 1]).norm();
    if (walked_m < length_m) break;
    walked_m -= length_m;
  }
  return next;
}

double Pedestrian::walked_m(double time_s) const {
  if (!started(time_s)) return 0.0;
  const double walking_s = time_s - start_s_ - waited_s_;
  const double withoutPause_m = walking_s * parameters_.speed_mps;
  if (withoutPause_m <= parameters_.pauseAfter_m) return std::max(0.0, withoutPause_m);
  return std::max(parameters_.pauseAfter_m,
                  (walking_s - parameters_.pause_s) * parameters_.speed_mps);
}

TPoint2D Pedestrian::position(double time_s) const { return pointAfter(walked_m(time_s)); }

TPoint2D Pedestrian::pointAfter(double walked_m) const {
  const auto& path = parameters_.path_m;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const TPoint2D segment = path[i] - path[i - 1];
    const double length_m = segment.norm();
    if (walked_m < length_m) return path[i - 1] + segment * (walked_m / length_m);
    walked_m -= length_m;
  }
  return path.back();
}

double Pedestrian::speed_mps(double time_s) const {
  constexpr double kMoment_s = 1e-3;
  const double walked = walked_m(time_s);
  const bool walking =
      started(time_s) && !waits_ && walked < pathLength_m_ && walked_m(time_s + kMoment_s) > walked;
  return walking ? parameters_.speed_mps : 0.0;
}

}  // namespace bslnav
