#include <bslnav/simulation/SimulationEngine.h>

#include <cmath>

namespace bslnav {

void SimulationEngine::step(const mrpt::math::TTwist2D& command, double dt_s) {
  constexpr double kTimeSlack_s = 1e-9;  // sums of substeps are not exact
  const int substeps = static_cast<int>(std::ceil(dt_s / kSubstep_s - kTimeSlack_s));
  for (int i = 0; i < substeps; ++i) substep(command, dt_s / substeps);
}

}  // namespace bslnav
