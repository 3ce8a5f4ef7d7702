#pragma once

#include <bslnav/costmap/CostGrid.h>
#include <bslnav/costmap/DangerZone.h>

#include <vector>

namespace bslnav {

/** The paper's blind spots layer: raises the costs within danger zones.
 *
 * A cell whose centre is at distance l <= R^o from P^o costs at least trunc(A·exp(−S·l)), at most
 * kHighestGradedCost (equation 9). No cost falls; lethal, inscribed and unknown cells stay what
 * they are. Zones without a positive finite radius and amplitude are ignored. Computed in single
 * precision.
 * @return the window that holds all zones, within the grid */
CellWindow addDangerZones(const std::vector<DangerZone>& zones, CostGrid& costs);

}  // namespace bslnav
