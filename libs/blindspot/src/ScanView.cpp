#include <bslnav/blindspot/ScanView.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bslnav {
namespace {

constexpr float kTurn = 2.0f * static_cast<float>(M_PI);
constexpr float kPerRadian = ScanView::kDirections / kTurn;
constexpr int kFewestFree = 3;        // so many neighbouring beams without return are a free view
constexpr float kMostMissing = 8.0f;  // dropped beams in a row, until there the view is not closed

float wrapped(float angle_rad) {
  return angle_rad - kTurn * std::floor((angle_rad + 0.5f * kTurn) / kTurn);
}

/** How many beams without return stand together at beam i. */
int freeRun(const PlanarScan& scan, int i) {
  const auto isFree = [&scan](int k) {
    return scan.beam[static_cast<std::size_t>(k)] == PlanarScan::Beam::NoReturn;
  };
  int first = i, last = i;
  while (first > 0 && i - first < kFewestFree && isFree(first - 1)) --first;
  while (last + 1 < scan.size() && last - i < kFewestFree && isFree(last + 1)) ++last;
  return last - first + 1;
}

}  // namespace

void ScanView::assign(const PlanarScan& scan, double gap_m) {
  const auto& sensor = scan.robotFromSensor();
  origin_ = {static_cast<float>(sensor.x), static_cast<float>(sensor.y)};
  surfaces_.clear();
  squaredReach_.fill(std::numeric_limits<float>::max());
  takeBeams(scan);
  for (std::size_t i = 1; i < beams_.size(); ++i)
    addWedge(beams_[i - 1], beams_[i], static_cast<float>(gap_m));
  if (beams_.size() > 2) addWedge(beams_.back(), beams_.front(), static_cast<float>(gap_m));
  for (float& reach : squaredReach_)
    if (reach == std::numeric_limits<float>::max()) reach = 0.0f;
}

void ScanView::takeBeams(const PlanarScan& scan) {
  beams_.clear();
  for (int i = 0; i < scan.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool hit = scan.beam[k] == PlanarScan::Beam::Hit;
    const bool free =
        !hit && scan.beam[k] == PlanarScan::Beam::NoReturn && freeRun(scan, i) >= kFewestFree;
    if (!hit && !free) continue;
    const float range = scan.range_m[k];
    beams_.push_back({std::atan2(scan.sine[k], scan.cosine[k]),
                      range,
                      hit,
                      {origin_.x + range * scan.cosine[k], origin_.y + range * scan.sine[k]}});
  }
  // The step of the sensor is that of any two beams in a row; the median would be dear.
  widestWedge_rad_ = kTurn / 16.0f;
  if (scan.size() > 1) {
    const float step = std::abs(wrapped(std::atan2(scan.sine[1], scan.cosine[1]) -
                                        std::atan2(scan.sine[0], scan.cosine[0])));
    widestWedge_rad_ = std::min(widestWedge_rad_, kMostMissing * step);
  }
}

/** What is seen between two neighbouring beams, `to` counterclockwise of `from`. */
void ScanView::addWedge(const Beam& from, const Beam& to, float gap_m) {
  const float span = wrapped(to.angle_rad - from.angle_rad);
  if (span <= 0.0f || span > widestWedge_rad_) return;
  const float dx = to.end.x - from.end.x, dy = to.end.y - from.end.y;
  const bool closed = from.hit && to.hit && dx * dx + dy * dy <= gap_m * gap_m;
  if (closed) surfaces_.push_back({from.end, to.end});
  const int first = static_cast<int>(std::floor((from.angle_rad + 0.5f * kTurn) * kPerRadian));
  const int count = static_cast<int>(std::ceil(span * kPerRadian)) + 1;
  const float nearer = std::min(from.range_m, to.range_m);
  const float inverse = 1.0f / from.range_m, change = 1.0f / to.range_m - inverse;
  for (int k = 0; k < count; ++k) {
    float reach = nearer;
    if (closed) {  // along a straight surface, 1/range is all but linear in the angle
      const float centre = (static_cast<float>(first + k) + 0.5f) / kPerRadian - 0.5f * kTurn;
      const float part = std::clamp((centre - from.angle_rad) / span, 0.0f, 1.0f);
      reach = 1.0f / (inverse + part * change);
    }
    float& here = squaredReach_[static_cast<std::size_t>((first + k) & (kDirections - 1))];
    here = std::min(here, reach * reach);
  }
}

}  // namespace bslnav
