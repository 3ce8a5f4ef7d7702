#pragma once

#include <bslnav/planning/CostTerms.h>
#include <bslnav/planning/Guard.h>
#include <bslnav/planning/MoverForecast.h>
#include <bslnav/planning/RobotLimits.h>
#include <bslnav/planning/Rollout.h>
#include <mrpt/math/TTwist2D.h>

#include <limits>
#include <vector>

namespace bslnav {

/** What the planner knows in one cycle. */
struct DwaInput {
  mrpt::math::TPose2D mapFromRobot;
  mrpt::math::TTwist2D twist;                     ///< robot frame
  const std::vector<mrpt::math::TPoint2D>& path;  ///< global path, map frame
  mrpt::math::TPoint2D goal;                      ///< local goal, map frame
  double goalTolerance_m = 0.0;  ///< above 0: a rollout that comes this near has reached the goal
  bool stopsAtGoal = true;       ///< with a tolerance: whether the robot is to stop there
  const Guard* guard = nullptr;  ///< what it refuses is not driven; null: anything may be
  const MoverForecast* movers = nullptr;  ///< whom not to be in the way of; null: nobody
  double maxSpeed_mps = std::numeric_limits<double>::max();  ///< wanted now
};

/** One velocity that was considered, with all that was thought of it. */
struct Candidate {
  enum class Verdict : std::uint8_t {
    Admissible,
    Obstacle,
    Unknown,
    Oscillation,
    OutOfWindow,
    Guarded  ///< somebody who may step out could reach the robot before it stands
  };
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
  std::vector<Candidate> candidates;  ///< all of them; of the dynamic window: from fast to slow

  /** The chosen candidate's velocity, robot frame; zero when there is none. */
  mrpt::math::TTwist2D chosenVelocity() const {
    if (best < 0) return {};
    return candidates[static_cast<std::size_t>(best)].twist();
  }
};

/** Chooses the velocity of one control cycle from candidates of its own kind. */
class LocalPlanner {
 public:
  virtual ~LocalPlanner() = default;

  /** Scores the candidates over the costs and chooses the cheapest admissible one. The result is
   * valid until the next call. */
  virtual const DwaResult& plan(const DwaInput& input, const CostGrid& costs) = 0;

  /** Forgets what it remembers of earlier cycles: after a new goal. */
  virtual void reset() = 0;
};

}  // namespace bslnav
