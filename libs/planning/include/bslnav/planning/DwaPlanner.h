#pragma once

#include <bslnav/planning/CandidateEvaluator.h>
#include <bslnav/planning/DynamicWindow.h>
#include <bslnav/planning/RobotLimits.h>

namespace bslnav {

/** The dynamic window approach with the paper's cost function (Methods 1 to 4): its candidates are
 * the velocities that the robot can reach. */
class DwaPlanner : public LocalPlanner {
 public:
  DwaPlanner(const DwaParameters& parameters, const RobotLimits& limits,
             const FootprintCover& footprint, double controlPeriod_s);

  /** Rolls out every candidate of the dynamic window; no allocation after the first call. */
  const DwaResult& plan(const DwaInput& input, const CostGrid& costs) override;
  void reset() override { evaluator_.reset(); }

 private:
  void sample(const DynamicWindow& window, const mrpt::math::TTwist2D& current,
              double speedCap_mps);

  DwaParameters parameters_;
  RobotLimits limits_;
  double controlPeriod_s_;
  CandidateEvaluator evaluator_;
  DwaResult result_;
};

}  // namespace bslnav
