#include <bslnav/planning/DwaPlanner.h>
#include <bslnav/planning/DynamicWindow.h>

namespace bslnav {

DwaPlanner::DwaPlanner(const DwaParameters& parameters, const RobotLimits& limits,
                       const FootprintCover& footprint, double controlPeriod_s)
    : parameters_(parameters),
      limits_(limits),
      controlPeriod_s_(controlPeriod_s),
      evaluator_(parameters, limits, footprint) {
  const int count = parameters.speedSamples * parameters.yawRateSamples;
  result_.candidates.resize(static_cast<std::size_t>(count));
}

const DwaResult& DwaPlanner::plan(const DwaInput& input, const CostGrid& costs) {
  evaluator_.begin(input, costs);
  const DynamicWindow window = dynamicWindow(input.twist, limits_, parameters_.window_s,
                                             speedCap(input, limits_, controlPeriod_s_));
  auto candidate = result_.candidates.begin();
  for (int i = parameters_.speedSamples - 1; i >= 0; --i)
    for (int k = 0; k < parameters_.yawRateSamples; ++k, ++candidate) {
      candidate->v_mps = sampleOf(window.vMin, window.vMax, i, parameters_.speedSamples);
      candidate->w_radps = sampleOf(window.wMin, window.wMax, k, parameters_.yawRateSamples);
      evaluator_.evaluate(*candidate);
    }
  evaluator_.choose(result_);
  result_.command = result_.best < 0
                        ? brake(input.twist, limits_, controlPeriod_s_)
                        : limited(result_.chosenVelocity(), input.twist, limits_, controlPeriod_s_);
  return result_;
}

}  // namespace bslnav
