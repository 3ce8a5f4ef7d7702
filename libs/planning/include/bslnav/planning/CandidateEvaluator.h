#pragma once

#include <bslnav/planning/DwaParameters.h>
#include <bslnav/planning/LocalPlanner.h>
#include <bslnav/planning/OscillationGuard.h>
#include <bslnav/planning/PathDistance.h>
#include <bslnav/planning/RobotLimits.h>

#include <vector>

namespace bslnav {

/** Scores candidates over the costs of one cycle with the paper's terms (eq. 10), and chooses the
 * cheapest. Where candidates come from, a window of velocities or the paths of a PTG, is their
 * source's business. */
class CandidateEvaluator {
 public:
  CandidateEvaluator(const DwaParameters& parameters, const RobotLimits& limits,
                     const FootprintCover& footprint);

  /** Takes over the situation of a cycle; the costs must stay until its last evaluation. */
  void begin(const DwaInput& input, const CostGrid& costs);

  /** Judges a candidate as a velocity that is kept for the whole horizon. */
  void evaluate(Candidate& candidate) const;
  /** Judges a candidate that drives along a path, as far as `reach_m` or to the path's end. */
  void evaluate(Candidate& candidate, const SampledPath& path, double reach_m) const;

  /** Finds the cheapest admissible candidate, and notes which way it turns; fills all of the result
   * but the command. */
  void choose(DwaResult& result);

  /** Forgets which way the robot turned: after a new goal. */
  void reset() { oscillation_.reset(); }

 private:
  bool mayDrive(Candidate& candidate) const;
  const Candidate& calmest(const std::vector<Candidate>& candidates, const Candidate& best) const;
  void judge(Candidate& candidate, const RolloutOutcome& rollout) const;

  DwaParameters parameters_;
  RobotLimits limits_;
  FootprintCover footprint_;
  OscillationGuard oscillation_;
  PathDistance pathDistance_;
  Cost goalCost_ = kFreeCost;  // graded cost of the goal's own cell
  RolloutSetup setup_;
  mrpt::math::TTwist2D twist_;  // that the robot has now
  const CostGrid* costs_ = nullptr;
  const Guard* guard_ = nullptr;
  const MoverForecast* movers_ = nullptr;
};

/** The highest speed that is wanted now: that of the input, and the robot does not creep towards a
 * goal, nor overshoot it. */
double speedCap(const DwaInput& input, const RobotLimits& limits, double controlPeriod_s);

}  // namespace bslnav
