#pragma once

namespace bslnav {

/** Squared lengths and directions (indices as ScanView's) of the vectors (x0 + i·step, y), turned
 * by `offset` directions; the arc tangent is exact to 1e-5 rad (Hastings' polynomial).
 *  @param directions and squared: `count` of each are written */
void polarRow(float x0, float y, float step, float offset, int count, int* directions,
              float* squared);

}  // namespace bslnav
