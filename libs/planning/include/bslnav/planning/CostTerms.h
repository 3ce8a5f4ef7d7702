#pragma once

#include <bslnav/config/ConfigSection.h>
#include <bslnav/costmap/CostValues.h>
#include <bslnav/planning/Rollout.h>

#include <algorithm>

namespace bslnav {

/** The weights and scales of the paper's cost J = W_pos·c_pos + W_gol·c_gol + W_dan·c_dan +
 * W_vel·c_vel (eq. 10, table I), and of our own W_mov·c_mov. */
struct CostWeights {
  double path = 2.0, goal = 1.0, danger = 10.0, velocity = 0.0;
  double movers = 0.0;  ///< W_mov: above the weight of 1/v at a standstill, or nobody is let pass
  double dangerDivisor =
      253.0;  ///< scales the highest cost to 0..1; with raw costs it drowns the other terms
  double speedFloor_mps = 0.05;  ///< c_vel = 1/v is limited to 1/floor

  void describe(ConfigSection& section);
};

/** The terms of one candidate, before weighting. */
struct CostTerms {
  double path = 0.0;  ///< c_pos: end point to the global path [m]
  double goal = 0.0;  ///< c_gol: end point to the local goal [m]; negative when it passes the goal
  double danger =
      0.0;  ///< c_dan: highest cost along the rollout / divisor; to the goal: above the goal's own
  double velocity = 0.0;  ///< c_vel: 1/v [s/m]
  double movers = 0.0;    ///< c_mov: how much in the way of people who walk, 0 to 2
};

/** c_gol. A rollout that passes the goal counts as if it went on: its term falls below zero by what
 * is left of it, so that near the goal, too, the faster candidate is the cheaper one. */
inline double goalTerm(const RolloutOutcome& rollout, double speed_mps, const RolloutSetup& setup) {
  if (rollout.end != RolloutOutcome::End::Goal) return (rollout.endPoint - setup.goal).norm();
  const mrpt::math::TPoint2D start{setup.start.x, setup.start.y};
  return std::min(0.0, (setup.goal - start).norm() - speed_mps * setup.horizon_s);
}
/** c_dan. @param unavoidable what the goal's own place costs, for a rollout that ends there; else 0
 */
inline double dangerTerm(Cost highestCost, Cost unavoidable, const CostWeights& weights) {
  return (std::max(highestCost, unavoidable) - unavoidable) / weights.dangerDivisor;
}
inline double velocityTerm(double speed_mps, const CostWeights& weights) {
  return 1.0 / std::max(speed_mps, weights.speedFloor_mps);
}

/** J of one candidate. */
inline double weighted(const CostTerms& c, const CostWeights& w) {
  return w.path * c.path + w.goal * c.goal + w.danger * c.danger + w.velocity * c.velocity +
         w.movers * c.movers;
}

}  // namespace bslnav
