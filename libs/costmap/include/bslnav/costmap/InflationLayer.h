#pragma once

#include <bslnav/config/ConfigSection.h>
#include <bslnav/costmap/CostGrid.h>

#include <cstdint>
#include <vector>

namespace bslnav {

/** How far obstacles reach, and how fast their cost falls. */
struct InflationParameters {
  double radius_m =
      0.55;  ///< no cost beyond this distance from an obstacle (the inscribed radius always has)
  double scaling_per_m = 10.0;  ///< decay of the graded cost

  void describe(ConfigSection& section);
};

/** Costs around lethal cells: 253 within the inscribed radius, then trunc(252·exp(−scaling·(d −
 * inscribed))) to the radius.
 *
 * d is the distance between cell centres, exact; the nearest lethal cell counts. A cell keeps the
 * higher of this and what it has. An unknown cell stays unknown unless it becomes inscribed: a
 * robot that centres there collides for certain. */
class InflationLayer {
 public:
  static constexpr int kMaxReach = 127;  ///< cells; squared distances stay within 16 bits

  /** @throws Error when the radius is more than kMaxReach cells. */
  InflationLayer(const InflationParameters& parameters, double inscribedRadius_m,
                 double resolution_m);

  /** How many cells away from an obstacle costs change. */
  int reach() const { return reach_; }
  /** Cost at a squared distance in cells; 254 at 0, 0 beyond the radius. */
  Cost costAt(int squaredCells) const;

  /** Writes the inflated costs of the cells in `window` into `out`, from `base`, a grid of the same
   * size. Lethal cells of `base` up to reach() cells outside the window count. */
  void apply(const CostGrid& base, const CellWindow& window, CostGrid& out);

 private:
  using Squared = std::int16_t;

  void reserveScratch(const CellWindow& target, int slots);
  void measureRow(const Cost* cells, int first, int last, const CellWindow& target, int slot);
  bool measureColumns(int slot, int count);
  void lookUpCosts(int count);

  int reach_ = 0;
  std::vector<Cost> costs_;     // by squared distance; the last one, 0, is for all beyond
  std::vector<Squared> stamp_;  // squared distances in a row to a lethal cell in the middle
  // Scratch of one call, reused. A slot is a row of the window and its surroundings.
  std::size_t stride_ = 0;
  std::vector<Squared> inRow_, far_, nearest_;
  std::vector<const Squared*> rows_;  // by slot + reach: in inRow_, or far_ without lethal cells
  std::vector<Cost> rowCosts_;
};

}  // namespace bslnav
