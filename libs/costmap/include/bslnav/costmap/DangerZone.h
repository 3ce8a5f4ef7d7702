#pragma once

#include <mrpt/math/TPoint2D.h>

namespace bslnav {

/** A disc in which a person may step out: cost = amplitude · exp(−scaling · distance to the
 * centre), 0 outside (paper, eq. 9). */
struct DangerZone {
  mrpt::math::TPoint2D centre;  ///< P^o, map frame [m]
  double radius_m = 0.0;        ///< R^o
  double amplitude = 253.0;     ///< A
  double scaling_per_m = 1.0;   ///< S
};

}  // namespace bslnav
