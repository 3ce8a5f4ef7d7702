#include <bslnav/config/Config.h>
#include <bslnav/costmap/InflationLayer.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace bslnav {
namespace {

constexpr std::int16_t kFar =
    16384;  // (kMaxReach + 1)²: no table gets there, and kFar + kMaxReach² still fits
constexpr double kRounding = 1e-9;

/** First lethal cell in [first, last), or last. */
int nextLethal(const Cost* cells, int first, int last) {
  const void* found =
      std::memchr(cells + first, kLethalCost, static_cast<std::size_t>(last - first));
  return found ? static_cast<int>(static_cast<const Cost*>(found) - cells) : last;
}

}  // namespace

void InflationParameters::describe(ConfigSection& section) {
  section.number("inflation_radius_m", radius_m, kNonNegative, "m",
                 "obstacles cost nothing beyond this distance");
  section.number("inflation_scaling_per_m", scaling_per_m, kNonNegative, "1/m",
                 "decay of the cost from the inscribed radius outwards");
}

InflationLayer::InflationLayer(const InflationParameters& parameters, double inscribedRadius_m,
                               double resolution_m) {
  const double cells = std::max(parameters.radius_m, inscribedRadius_m) / resolution_m;
  if (!(cells < kMaxReach + 1))
    Config::refuse(
        "costmap", "inflation_radius_m",
        "at most " + std::to_string(kMaxReach) + " cells (robot's inscribed radius included)");
  reach_ = static_cast<int>(cells + kRounding);
  costs_.push_back(kLethalCost);
  for (int squared = 1; squared <= cells * cells + kRounding; ++squared) {
    const double d_m = std::sqrt(squared) * resolution_m, beyond_m = d_m - inscribedRadius_m;
    const double graded = kHighestGradedCost * std::exp(-parameters.scaling_per_m * beyond_m);
    costs_.push_back(beyond_m <= kRounding ? kInscribedCost : static_cast<Cost>(graded));
  }
  for (int dx = -reach_; dx <= reach_; ++dx) stamp_.push_back(static_cast<Squared>(dx * dx));
  stamp_.resize((stamp_.size() + 7) / 8 * 8, kFar);  // whole vectors
}

Cost InflationLayer::costAt(int squaredCells) const {
  return squaredCells < static_cast<int>(costs_.size())
             ? costs_[static_cast<std::size_t>(squaredCells)]
             : kFreeCost;
}

void InflationLayer::apply(const CostGrid& base, const CellWindow& window, CostGrid& out) {
  const CellWindow target = window.intersected(base.bounds());
  if (target.empty()) return;
  const CellWindow source = target.grown(reach_).intersected(base.bounds());
  stride_ = static_cast<std::size_t>(target.width() + 4 * reach_ + 8);
  slots_ = source.height();
  const auto slots = static_cast<std::size_t>(slots_);
  if (inRow_.size() < slots * stride_) inRow_.resize(slots * stride_);
  if (occupied_.size() < slots) occupied_.resize(slots);
  if (far_.size() < stride_) far_.assign(stride_, kFar), nearest_.resize(stride_);

  for (int y = source.y0; y < source.y1; ++y)
    measureRow(base.row(y), source.x0, source.x1, target, y - source.y0);
  for (int y = target.y0; y < target.y1; ++y) {
    std::memcpy(out.row(y) + target.x0, base.row(y) + target.x0,
                static_cast<std::size_t>(target.width()));
    if (measureColumns(y - source.y0))
      grade(base.row(y) + target.x0, out.row(y) + target.x0, target.width());
  }
}

/** For each cell of the target's columns the squared distance to the nearest lethal cell in its
 * row. The slot starts 2·reach cells before the target, so that stamps need no clipping. */
void InflationLayer::measureRow(const Cost* cells, int first, int last, const CellWindow& target,
                                int slot) {
  int x = nextLethal(cells, first, last);
  occupied_[static_cast<std::size_t>(slot)] = x < last;
  if (x >= last) return;
  Squared* const row = inRow_.data() + static_cast<std::size_t>(slot) * stride_;
  std::fill(row, row + stride_, kFar);
  const auto stamp = [&](int lethal) {
    Squared* to = row + (lethal - target.x0 + reach_);
    for (std::size_t i = 0; i < stamp_.size(); ++i) to[i] = std::min(to[i], stamp_[i]);
  };
  while (x < last) {
    int end = x + 1;
    while (end < last && cells[end] == kLethalCost) ++end;
    stamp(x);
    if (end > x + 1) stamp(end - 1);
    Squared* const run = row + (2 * reach_ + x - target.x0);
    std::fill(run, run + (end - x), Squared{0});
    x = nextLethal(cells, end, last);
  }
}

const InflationLayer::Squared* InflationLayer::rowOrFar(int slot) const {
  const bool has = slot >= 0 && slot < slots_ && occupied_[static_cast<std::size_t>(slot)];
  return (has ? inRow_.data() + static_cast<std::size_t>(slot) * stride_ : far_.data()) +
         2 * reach_;
}

/** Fills nearest_ with the least of in-row distance² + dy² over the rows around a slot; false if
 * there is none. */
bool InflationLayer::measureColumns(int slot) {
  const Squared* const far = rowOrFar(-1);
  const Squared* const own = rowOrFar(slot);
  const int count = static_cast<int>(stride_) - 4 * reach_ - 8;
  Squared* const nearest = nearest_.data();
  bool any = own != far;
  std::memcpy(nearest, own, static_cast<std::size_t>(count) * sizeof(Squared));
  for (int dy = 1; dy <= reach_; ++dy) {
    const Squared *const below = rowOrFar(slot - dy), *const above = rowOrFar(slot + dy);
    if (below == far && above == far) continue;
    any = true;
    const auto squared = static_cast<Squared>(dy * dy);
    for (int x = 0; x < count; ++x) {
      const auto reached = static_cast<Squared>(std::min(below[x], above[x]) + squared);
      nearest[x] = std::min(nearest[x], reached);
    }
  }
  return any;
}

void InflationLayer::grade(const Cost* base, Cost* out, int count) const {
  const auto beyond = static_cast<Squared>(costs_.size());
  const Squared* const nearest = nearest_.data();
  for (int x = 0; x < count; ++x) {
    if (nearest[x] >= beyond) continue;
    const Cost cost = costs_[static_cast<std::size_t>(nearest[x])];
    if (base[x] == kUnknownCost)
      out[x] = cost >= kInscribedCost ? cost : kUnknownCost;
    else
      out[x] = std::max(base[x], cost);
  }
}

}  // namespace bslnav
