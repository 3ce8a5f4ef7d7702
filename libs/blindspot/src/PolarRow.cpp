#include "PolarRow.h"

#include <bslnav/blindspot/ScanView.h>
#include <bslnav/config/VectorClones.h>

#include <cmath>

namespace bslnav {

BSLNAV_VECTOR_CLONES
void polarRow(float x0, float y, float step, float offset, int count, int* directions,
              float* squared) {
  constexpr float kPerTurn = ScanView::kDirections, kPerRadian = kPerTurn / (2.0f * 3.14159265f);
  for (int i = 0; i < count; ++i) {
    const float x = x0 + step * static_cast<float>(i);
    const float ax = std::abs(x), ay = std::abs(y);
    const float low = ax < ay ? ax : ay, high = ax < ay ? ay : ax;
    const float t = low / (high + 1e-9f), t2 = t * t;
    float a =
        t *
        (0.99997726f +
         t2 * (-0.33262347f +
               t2 * (0.19354346f + t2 * (-0.11643287f + t2 * (0.05265332f - 0.01172120f * t2)))));
    a = ax < ay ? 1.57079633f - a : a;
    a = x < 0.0f ? 3.14159265f - a : a;
    a = y < 0.0f ? -a : a;
    // Two turns are added, so that cutting off rounds down.
    directions[i] =
        static_cast<int>(a * kPerRadian + offset + 2.5f * kPerTurn) & (ScanView::kDirections - 1);
    squared[i] = x * x + y * y;
  }
}

BSLNAV_VECTOR_CLONES
void markNearer(const int* __restrict directions, const float* __restrict squared,
                const float* __restrict reach, int count, Cost* __restrict row) {
  for (int i = 0; i < count; ++i)
    row[i] = static_cast<Cost>(row[i] | (squared[i] < reach[directions[i]] ? 255 : 0));
}

BSLNAV_VECTOR_CLONES
void markDirections(const int* __restrict directions, const int* __restrict which, int count,
                    Cost* __restrict marked, Cost* __restrict cleared) {
  for (int i = 0; i < count; ++i) {
    const int here = which[directions[i]];
    marked[i] = static_cast<Cost>(marked[i] | here);
    cleared[i] = static_cast<Cost>(cleared[i] & ~here);
  }
}

}  // namespace bslnav
