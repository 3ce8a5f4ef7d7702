#pragma once

#include <bslnav/planning/CostTerms.h>
#include <bslnav/planning/DynamicWindow.h>
#include <bslnav/planning/OscillationGuard.h>
#include <bslnav/planning/PathDistance.h>
#include <bslnav/planning/Rollout.h>

#include <vector>

namespace bslnav {

struct DwaParameters {
  double horizon_s = 4.0;  ///< T_pre
  double step_s = 0.1;
  double window_s = 1.0;  ///< within one control period a robot that stands could only creep, and
                          ///< creeping never pays for crossing a graded cost
  int speedSamples = 20, yawRateSamples = 40;
  int lateralSamples = 1;  ///< counts for a robot that can move sideways
  bool allowUnknown = false;
  CostWeights weights;
  OscillationParameters oscillation;

  void describe(ConfigSection& section);
};

/** What the planner knows in one cycle. */
struct DwaInput {
  mrpt::math::TPose2D mapFromRobot;
  mrpt::math::TTwist2D twist;                     ///< robot frame
  const std::vector<mrpt::math::TPoint2D>& path;  ///< global path, map frame
  mrpt::math::TPoint2D goal;                      ///< local goal, map frame
  double goalTolerance_m = 0.0;  ///< above 0: a rollout that comes this near has reached the goal
  bool stopsAtGoal = true;       ///< with a tolerance: whether the robot is to stop there
};

/** One velocity that was considered, with all that was thought of it. */
struct Candidate {
  enum class Verdict : std::uint8_t { Admissible, Obstacle, Unknown, Oscillation };
  double v_mps = 0.0, w_radps = 0.0;
  double vy_mps = 0.0;  ///< to the left
  CostTerms terms;      ///< zero unless admissible
  double total = 0.0;   ///< J
  Verdict verdict = Verdict::Admissible;
  int steps = 0;  ///< of the rollout

  mrpt::math::TTwist2D twist() const { return {v_mps, vy_mps, w_radps}; }
  double speed_mps() const { return speedOf(twist()); }
};

struct DwaResult {
  enum class Status : std::uint8_t { Ok, NoAdmissible };
  Status status = Status::NoAdmissible;
  mrpt::math::TTwist2D command;       ///< within the limits; brakes when nothing is admissible
  int best = -1;                      ///< index of the chosen candidate, -1 when none
  RolloutSetup setup;                 ///< to draw the rollouts
  std::vector<Candidate> candidates;  ///< all of them, speeds from fast to slow
};

/** The dynamic window approach with the paper's cost function (Methods 1 to 4). */
class DwaPlanner {
 public:
  DwaPlanner(const DwaParameters& parameters, const RobotLimits& limits,
             const FootprintCover& footprint, double controlPeriod_s);

  /** Rolls out every candidate of the dynamic window over the costs and chooses the cheapest
   * admissible one. The result is valid until the next call; no allocation after the first. */
  const DwaResult& plan(const DwaInput& input, const CostGrid& costs);

  /** Forgets which way the robot turned: after a new goal. */
  void reset() { oscillation_.reset(); }

 private:
  void sample(const DynamicWindow& window, const mrpt::math::TTwist2D& current,
              double speedCap_mps);
  void evaluate(Candidate& candidate, const CostGrid& costs) const;
  void choose(const DwaInput& input);

  DwaParameters parameters_;
  RobotLimits limits_;
  FootprintCover footprint_;
  double controlPeriod_s_;
  OscillationGuard oscillation_;
  PathDistance pathDistance_;
  Cost goalCost_ = kFreeCost;  // graded cost of the goal's own cell
  DwaResult result_;
};

}  // namespace bslnav
