#include <bslnav/config/VectorClones.h>
#include <bslnav/costmap/BlindSpotLayer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace bslnav {
namespace {

constexpr int kLanes = 16;  // cells are computed in multiples of it: whole vectors, no scalar rest
constexpr int kMostLanes = 8 * kLanes;  // at once

/** Indices of the cells in [0, count) whose centres lie in [low, high], both in cells; half-open.
 */
struct Span {
  int first, last;
  Span(double low, double high, int count) {
    const double from = std::clamp(low - 0.5, 0.0, static_cast<double>(count));
    first = static_cast<int>(from);
    if (first < from) ++first;
    last = static_cast<int>(std::clamp(high + 0.5, 0.0, static_cast<double>(count)));
  }
};

/** 2^−t for 0 <= t <= 120 to 3e-7, in operations that compilers turn into vector code: 2^(i + f),
 * |f| <= 1/2, by Taylor. */
inline float halved(float t) {
  constexpr float kHalf = 0.5f;
  const auto i = static_cast<std::int32_t>(t + kHalf);  // rounds, since t >= 0
  const float u = (static_cast<float>(i) - t) * 0.69314718f;
  const float p =
      1.0f + u * (1.0f + u * (0.5f + u * (1.0f / 6 +
                                          u * (1.0f / 24 + u * (1.0f / 120 + u * (1.0f / 720))))));
  const std::int32_t bits = (127 - i) << 23;
  float power;
  std::memcpy(&power, &bits, sizeof power);
  return p * power;
}

constexpr float kFarthest = 120.0f;  // halvings: less than 1 is left of any cost by then

/** Equation 9 for whole lanes of cells in a row, min(highest, amplitude · 2^−distance), in lengths
 * over which the cost halves: dx0 is from the zone's centre to the centre of the first cell, `cell`
 * a cell's side. The limits are arguments because GCC makes branches of std::min with constants. */
BSLNAV_VECTOR_CLONES void fillCosts(float dx0, float dySquared, float cell, float farthest,
                                    float amplitude, float highest, int lanes, Cost* costs) {
  for (int i = 0; i < lanes * kLanes; ++i) {
    const float dx = dx0 + static_cast<float>(i) * cell;
    const float distance = std::min(farthest, std::sqrt(dx * dx + dySquared));
    const float cost = std::min(highest, amplitude * halved(distance));
    costs[i] = static_cast<Cost>(static_cast<std::int32_t>(cost));
  }
}

void raise(Cost* cells, const Cost* costs, int count) {
  for (int i = 0; i < count; ++i) cells[i] = std::max(cells[i], costs[i]);
}

/** Raises the cells of a row that lie in `xs`; dx0_m is from the zone's centre to the centre of
 * cell 0. */
void raiseRow(Cost* row, const Span& xs, double dx0_m, double dy_m, double resolution_m,
              const DangerZone& zone) {
  const double perMetre = zone.scaling_per_m / 0.6931471805599453;  // halvings
  const double dy = dy_m * perMetre, cell = resolution_m * perMetre;
  Cost costs[kMostLanes];
  for (int x = xs.first; x < xs.last; x += kMostLanes) {
    const int count = std::min(kMostLanes, xs.last - x);
    fillCosts(static_cast<float>(dx0_m * perMetre + x * cell), static_cast<float>(dy * dy),
              static_cast<float>(cell), kFarthest, static_cast<float>(zone.amplitude),
              static_cast<float>(kHighestGradedCost), (count + kLanes - 1) / kLanes, costs);
    raise(row + x, costs, count);
  }
}

CellWindow addDangerZone(const DangerZone& zone, CostGrid& costs) {
  const double resolution_m = costs.getResolution(), radius = zone.radius_m / resolution_m;
  const double cx = (zone.centre.x - costs.getXMin()) / resolution_m,
               cy = (zone.centre.y - costs.getYMin()) / resolution_m;
  const bool valid = zone.radius_m > 0.0 && zone.amplitude > 0.0 && zone.scaling_per_m >= 0.0;
  if (!valid || !std::isfinite(cx + cy + radius + zone.scaling_per_m)) return {};
  const Span ys(cy - radius, cy + radius, costs.height());
  for (int y = ys.first; y < ys.last; ++y) {
    const double dy = y + 0.5 - cy, half = std::sqrt(std::max(0.0, radius * radius - dy * dy));
    raiseRow(costs.row(y), Span(cx - half, cx + half, costs.width()), (0.5 - cx) * resolution_m,
             dy * resolution_m, resolution_m, zone);
  }
  const Span xs(cx - radius, cx + radius, costs.width());
  return {xs.first, ys.first, xs.last, ys.last};
}

}  // namespace

CellWindow addDangerZones(const std::vector<DangerZone>& zones, CostGrid& costs) {
  CellWindow all;
  for (const auto& zone : zones) all = all.united(addDangerZone(zone, costs));
  return all;
}

}  // namespace bslnav
