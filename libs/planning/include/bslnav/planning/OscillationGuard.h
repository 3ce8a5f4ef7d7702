#pragma once

#include <bslnav/config/ConfigSection.h>
#include <mrpt/math/TPose2D.h>

namespace bslnav {

struct OscillationParameters {
  double resetDistance_m = 0.1;  ///< this far on, every turn is allowed again
  double resetAngle_rad = 0.35;  ///< turned this far, too
  double slowSpeed_mps = 0.05;   ///< turning on the spot means: slower than this

  void describe(ConfigSection& section);
};

/** Keeps a robot that turns on the spot from turning back and forth: once it turned to one side,
 * turning to the other side on the spot is not admissible until it has moved or turned on. */
class OscillationGuard {
 public:
  explicit OscillationGuard(const OscillationParameters& parameters) : parameters_(parameters) {}

  bool allows(double speed_mps, double w_radps) const {
    return side_ == 0 || speed_mps >= parameters_.slowSpeed_mps || w_radps * side_ >= 0.0;
  }
  /** Told once a cycle what was commanded, and where. */
  void commanded(double speed_mps, double w_radps, const mrpt::math::TPose2D& pose);
  void reset() { side_ = 0; }

 private:
  OscillationParameters parameters_;
  int side_ = 0;  // +1 left, -1 right, 0 not turning on the spot
  mrpt::math::TPose2D since_;
};

}  // namespace bslnav
