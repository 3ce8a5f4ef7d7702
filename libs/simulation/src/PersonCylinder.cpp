#include "PersonCylinder.h"

#include <bslnav/config/VectorClones.h>

#include <cmath>

namespace bslnav {
namespace {

// Seen from above, the point at t of a ray is within the circle while a·t² − 2·b·t + c < 0, with
// a = |d|², b = d·m, c = |m|² − r²: d the direction, m the circle's centre from the ray's origin.

BSLNAV_VECTOR_CLONES int meets(float mx, float my, float c, const float* dx, const float* dy) {
  int result = 0;
  for (std::size_t i = 0; i < RayPacket::kSize; ++i) {
    const float a = dx[i] * dx[i] + dy[i] * dy[i];
    const float b = dx[i] * mx + dy[i] * my;
    result |= static_cast<int>(b > 0.0f) & static_cast<int>(b * b > a * c);
  }
  return result;
}

}  // namespace

bool PersonCylinder::mayBeHitBy(const mrpt::math::TPoint3Df& origin, const float* directionsX,
                                const float* directionsY) const {
  const float mx = x - origin.x, my = y - origin.y;
  return meets(mx, my, mx * mx + my * my - radius * radius, directionsX, directionsY) != 0;
}

float PersonCylinder::hit(const mrpt::math::TPoint3Df& origin,
                          const mrpt::math::TPoint3Df& direction, float limit) const {
  const float mx = x - origin.x, my = y - origin.y;
  const float a = direction.x * direction.x + direction.y * direction.y;
  const float b = direction.x * mx + direction.y * my;
  const float discriminant = b * b - a * (mx * mx + my * my - radius * radius);
  if (!(discriminant > 0.0f)) return limit;
  const float root = std::sqrt(discriminant);
  float t = (b - root) / a;
  if (origin.z + t * direction.z > height) {
    t = (height - origin.z) / direction.z;
    if (!(direction.z < 0.0f && t < (b + root) / a)) return limit;
  }
  return t > 0.0f && t < limit ? t : limit;
}

}  // namespace bslnav
