#pragma once

#include <mrpt/math/TPoint3D.h>

#include <optional>
#include <vector>

namespace bslnav {

/** Looks for the floor among points of surfaces that lie flat or nearly so. */
class FloorCheck {
 public:
  struct Plane {
    double height_m;  ///< above where the camera's foot is said to be
    double rise_x, rise_y;
  };

  void clear() { points_.clear(); }
  /** A point of such a surface, from the camera's foot. */
  void add(const mrpt::math::TPoint3Df& p) { points_.push_back(p); }
  std::size_t size() const { return points_.size(); }

  /** The plane that most points lie in, when next to none of them lie at the floor's height: the
   * floor is where it cannot be. */
  std::optional<Plane> misplacedFloor() const;

 private:
  Plane fitted(const Plane& guess, double within_m) const;
  double shareOf(const Plane& plane, double within_m) const;

  std::vector<mrpt::math::TPoint3Df> points_;
};

}  // namespace bslnav
