#include <bslnav/planning/DwaPlanner.h>

namespace bslnav {

DwaPlanner::DwaPlanner(const DwaParameters& parameters, const RobotLimits& limits,
                       const FootprintCover& footprint, double controlPeriod_s)
    : parameters_(parameters),
      limits_(limits),
      controlPeriod_s_(controlPeriod_s),
      evaluator_(parameters, limits, footprint) {
  if (limits.maxLateralSpeed_mps == 0.0) parameters_.lateralSamples = 1;
  const int count =
      parameters.speedSamples * parameters_.lateralSamples * parameters.yawRateSamples;
  result_.candidates.resize(static_cast<std::size_t>(count));
}

const DwaResult& DwaPlanner::plan(const DwaInput& input, const CostGrid& costs) {
  evaluator_.begin(input, costs);
  const double cap = speedCap(input, limits_, controlPeriod_s_);
  sample(dynamicWindow(input.twist, limits_, parameters_.window_s, cap), input.twist, cap);
  for (Candidate& candidate : result_.candidates) evaluator_.evaluate(candidate);
  evaluator_.choose(result_);
  result_.command = result_.best < 0
                        ? brake(input.twist, limits_, controlPeriod_s_)
                        : limited(result_.chosenVelocity(), input.twist, limits_, controlPeriod_s_);
  return result_;
}

void DwaPlanner::sample(const DynamicWindow& window, const mrpt::math::TTwist2D& current,
                        double speedCap_mps) {
  const int speeds = parameters_.speedSamples, sides = parameters_.lateralSamples;
  const int turns = parameters_.yawRateSamples;
  auto candidate = result_.candidates.begin();
  for (int i = speeds - 1; i >= 0; --i)
    for (int j = 0; j < sides; ++j)
      for (int k = 0; k < turns; ++k, ++candidate) {
        const auto twist = withinWindow({sampleOf(window.vMin, window.vMax, i, speeds),
                                         sampleOf(window.vyMin, window.vyMax, j, sides),
                                         sampleOf(window.wMin, window.wMax, k, turns)},
                                        current, limits_, parameters_.window_s, speedCap_mps);
        candidate->v_mps = twist.vx;
        candidate->vy_mps = twist.vy;
        candidate->w_radps = twist.omega;
      }
}

}  // namespace bslnav
