#pragma once

#include <bslnav/costmap/CostGrid.h>

namespace bslnav {

/** Squared lengths and directions (indices as ScanView's) of the vectors (x0 + i·step, y), turned
 * by `offset` directions; the arc tangent is exact to 1e-5 rad (Hastings' polynomial).
 *  @param directions and squared: `count` of each are written */
void polarRow(float x0, float y, float step, float offset, int count, int* directions,
              float* squared);

/** Sets to 255 in a row what is nearer than the view reaches in its direction.
 *  @param reach squared, of each direction */
void markNearer(const int* directions, const float* squared, const float* reach, int count,
                Cost* row);

/** Sets to 255 in a row what lies in some directions, and to 0 in another row.
 *  @param which 255 for those directions, else 0 */
void markDirections(const int* directions, const int* which, int count, Cost* marked,
                    Cost* cleared);

}  // namespace bslnav
