#include <bslnav/costmap/BlindSpotLayer.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "VectorClones.h"

namespace bslnav {
namespace {

constexpr int kBlock = 16;  // cells computed at once: whole vectors, without a scalar rest

/** Indices of the cells in [0, count) whose centres lie in [low, high], both in cells; half-open.
 */
struct Span {
  int first, last;
  Span(double low, double high, int count)
      : first(static_cast<int>(std::ceil(std::clamp(low - 0.5, 0.0, static_cast<double>(count))))),
        last(static_cast<int>(std::floor(std::clamp(high - 0.5, -1.0, count - 1.0))) + 1) {}
};

/** exp(x) for −80 <= x <= 0 to 3e-7, in operations that compilers turn into vector code: 2^(i + f),
 * |f| <= 1/2, by Taylor. */
float decay(float x) {
  const float t = x * 1.44269504f;
  const auto i = static_cast<std::int32_t>(t - 0.5f);  // rounds to the nearest, since t <= 0
  const float u = (t - static_cast<float>(i)) * 0.69314718f;
  const float p =
      1.0f + u * (1.0f + u * (0.5f + u * (1.0f / 6 +
                                          u * (1.0f / 24 + u * (1.0f / 120 + u * (1.0f / 720))))));
  const std::int32_t bits = (i + 127) << 23;
  float power;
  std::memcpy(&power, &bits, sizeof power);
  return p * power;
}

/** Costs of `kBlock` cells of a row; dx_m is from the zone's centre to the centre of the first. */
inline void costsOfBlock(float dx_m, float dySquared_m2, float resolution_m, float amplitude,
                         float scaling, Cost* costs) {
  for (int i = 0; i < kBlock; ++i) {
    const float dx = dx_m + static_cast<float>(i) * resolution_m;
    const float exponent = std::min(80.0f, scaling * std::sqrt(dx * dx + dySquared_m2));
    const float cost =
        std::min(static_cast<float>(kHighestGradedCost), amplitude * decay(-exponent));
    costs[i] = static_cast<Cost>(static_cast<std::int32_t>(cost));
  }
}

/** Raises the cells of a row that lie in `xs`; dx0_m is from the zone's centre to the centre of
 * cell 0. */
BSLNAV_VECTOR_CLONES void raiseRow(Cost* row, const Span& xs, float dx0_m, float dySquared_m2,
                                   float resolution_m, float amplitude, float scaling) {
  for (int x = xs.first; x < xs.last; x += kBlock) {
    Cost costs[kBlock];
    costsOfBlock(dx0_m + static_cast<float>(x) * resolution_m, dySquared_m2, resolution_m,
                 amplitude, scaling, costs);
    const int count = std::min(kBlock, xs.last - x);
    if (count == kBlock)
      for (int i = 0; i < kBlock; ++i) row[x + i] = std::max(row[x + i], costs[i]);
    else
      for (int i = 0; i < count; ++i) row[x + i] = std::max(row[x + i], costs[i]);
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
    const double dy_m = dy * resolution_m;
    raiseRow(costs.row(y), Span(cx - half, cx + half, costs.width()),
             static_cast<float>((0.5 - cx) * resolution_m), static_cast<float>(dy_m * dy_m),
             static_cast<float>(resolution_m), static_cast<float>(zone.amplitude),
             static_cast<float>(zone.scaling_per_m));
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
