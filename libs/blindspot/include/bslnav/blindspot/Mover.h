#pragma once

#include <mrpt/math/TPoint2D.h>

#include <vector>

namespace bslnav {

/** Somebody who is seen walking; map frame. */
struct Mover {
  mrpt::math::TPoint2D position;  ///< of the middle of what is seen [m]
  mrpt::math::TPoint2D velocity;  ///< [m/s]
};
using Movers = std::vector<Mover>;

}  // namespace bslnav
