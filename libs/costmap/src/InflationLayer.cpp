#include <bslnav/config/Config.h>
#include <bslnav/config/VectorClones.h>
#include <bslnav/costmap/InflationLayer.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace bslnav {
namespace {

constexpr std::int16_t kFar =
    16384;  // (kMaxReach + 1)²: no table gets there, and kFar + kMaxReach² still fits
constexpr int kBlock = 16;  // cells looked up at once
constexpr double kRounding = 1e-9;

/** First lethal cell in [first, last), or last. */
int nextLethal(const Cost* cells, int first, int last) {
  const void* found =
      std::memchr(cells + first, kLethalCost, static_cast<std::size_t>(last - first));
  return found ? static_cast<int>(static_cast<const Cost*>(found) - cells) : last;
}

/** Lowers `nearest` to min(below, above) + squared. */
BSLNAV_VECTOR_CLONES void lower(const std::int16_t* below, const std::int16_t* above,
                                std::int16_t squared, std::int16_t* nearest, int count) {
  for (int x = 0; x < count; ++x) {
    const auto reached = static_cast<std::int16_t>(std::min(below[x], above[x]) + squared);
    nearest[x] = std::min(nearest[x], reached);
  }
}

/** The higher cost, but an unknown cell stays unknown unless it becomes inscribed. */
BSLNAV_VECTOR_CLONES void combine(const Cost* base, const Cost* inflated, Cost* out, int count) {
  for (int x = 0; x < count; ++x) {
    const Cost higher = base[x] > inflated[x] ? base[x] : inflated[x];
    const bool replaced = (base[x] == kUnknownCost) & (inflated[x] >= kInscribedCost);
    out[x] = replaced ? inflated[x] : higher;
  }
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
  costs_.push_back(kFreeCost);
  for (int dx = -reach_; dx <= reach_; ++dx) stamp_.push_back(static_cast<Squared>(dx * dx));
  stamp_.resize((stamp_.size() + 7) / 8 * 8, kFar);  // whole vectors
}

Cost InflationLayer::costAt(int squaredCells) const {
  return costs_[std::min(static_cast<std::size_t>(squaredCells), costs_.size() - 1)];
}

void InflationLayer::apply(const CostGrid& base, const CellWindow& window, CostGrid& out) {
  const CellWindow target = window.intersected(base.bounds());
  if (target.empty()) return;
  const CellWindow source = target.grown(reach_).intersected(base.bounds());
  reserveScratch(target, source.height());
  for (int y = source.y0; y < source.y1; ++y)
    measureRow(base.row(y), source.x0, source.x1, target, y - source.y0);
  for (int y = target.y0; y < target.y1; ++y) {
    const Cost* const from = base.row(y) + target.x0;
    Cost* const to = out.row(y) + target.x0;
    if (measureColumns(y - source.y0, target.width())) {
      lookUpCosts(target.width());
      combine(from, rowCosts_.data(), to, target.width());
    } else {
      std::memcpy(to, from, static_cast<std::size_t>(target.width()));
    }
  }
}

void InflationLayer::reserveScratch(const CellWindow& target, int slots) {
  const int stride = target.width() + 4 * reach_ + kBlock, rows = slots + 2 * reach_;
  stride_ = static_cast<std::size_t>(stride);
  const std::size_t cells = static_cast<std::size_t>(slots) * stride_;
  if (inRow_.size() < cells) inRow_.resize(cells);
  if (far_.size() < stride_) {
    far_.assign(stride_, kFar);
    nearest_.resize(stride_);
    rowCosts_.resize(stride_);
  }
  rows_.assign(static_cast<std::size_t>(rows), far_.data());
}

/** For each cell of the target's columns the squared distance to the nearest lethal cell in its
 * row. The slot starts 2·reach cells before the target, so that stamps need no clipping. */
void InflationLayer::measureRow(const Cost* cells, int first, int last, const CellWindow& target,
                                int slot) {
  int x = nextLethal(cells, first, last);
  if (x >= last) return;
  Squared* const row = inRow_.data() + static_cast<std::size_t>(slot) * stride_;
  const int place = slot + reach_, margin = 2 * reach_;
  rows_[static_cast<std::size_t>(place)] = row + margin;
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

/** Fills nearest_ with the least of in-row distance² + dy² over the rows around a slot; false if
 * there is none. */
bool InflationLayer::measureColumns(int slot, int count) {
  const Squared* const far = far_.data();
  const Squared* const* const own = rows_.data() + (slot + reach_);
  bool any = false;
  std::fill_n(nearest_.data(), stride_, static_cast<Squared>(costs_.size() - 1));
  for (int dy = 0; dy <= reach_; ++dy) {
    if (own[-dy] == far && own[dy] == far) continue;
    any = true;
    lower(own[-dy], own[dy], static_cast<Squared>(dy * dy), nearest_.data(), count);
  }
  return any;
}

/** Fills rowCosts_ from nearest_; most blocks of a usual map are far from everything. */
void InflationLayer::lookUpCosts(int count) {
  const Cost* const table = costs_.data();
  const auto beyond = static_cast<Squared>(costs_.size() - 1);
  for (int x = 0; x < count; x += kBlock) {
    const Squared* const nearest = nearest_.data() + x;
    Cost* const costs = rowCosts_.data() + x;
    Squared least = beyond;
    for (int i = 0; i < kBlock; ++i) least = std::min(least, nearest[i]);
    if (least == beyond)
      std::fill(costs, costs + kBlock, kFreeCost);
    else
      for (int i = 0; i < kBlock; ++i) costs[i] = table[nearest[i]];
  }
}

}  // namespace bslnav
