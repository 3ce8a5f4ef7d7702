#pragma once

#include <bslnav/simulation/RayScene.h>

namespace bslnav {

/** A person as rays see it: an upright cylinder on the floor; map frame. */
struct PersonCylinder {
  float x, y, radius, height;

  /** Whether one of eight rays, seen from above, meets the circle ahead: most packets do not. */
  bool mayBeHitBy(const mrpt::math::TPoint3Df& origin, const float* directionsX,
                  const float* directionsY) const;

  /** How far along `direction` a ray comes to the side or from above to the top, in lengths of
   *  `direction`; `limit` when that is nearer. From within, the cylinder is not seen. */
  float hit(const mrpt::math::TPoint3Df& origin, const mrpt::math::TPoint3Df& direction,
            float limit) const;
};

}  // namespace bslnav
