#include <bslnav/planning/OscillationGuard.h>
#include <mrpt/math/wrap2pi.h>

#include <cmath>

namespace bslnav {

void OscillationParameters::describe(ConfigSection& section) {
  section.number("oscillation_reset_distance_m", resetDistance_m, kNonNegative, "m",
                 "after turning on the spot, turning back is allowed again this far on");
  section.angle("oscillation_reset_deg", resetAngle_rad, {0.0, 360.0},
                "after turning on the spot, turning back is allowed again after this turn");
  section.number("oscillation_speed_mps", slowSpeed_mps, kNonNegative, "m/s",
                 "slower than this is turning on the spot");
}

void OscillationGuard::commanded(double speed_mps, double w_radps,
                                 const mrpt::math::TPose2D& pose) {
  if (side_ != 0) {
    const double moved = std::hypot(pose.x - since_.x, pose.y - since_.y);
    const double turned = std::abs(mrpt::math::wrapToPi(pose.phi - since_.phi));
    if (moved >= parameters_.resetDistance_m || turned >= parameters_.resetAngle_rad) side_ = 0;
  }
  if (side_ == 0 && speed_mps < parameters_.slowSpeed_mps && w_radps != 0.0) {
    side_ = w_radps > 0.0 ? 1 : -1;
    since_ = pose;
  }
}

}  // namespace bslnav
