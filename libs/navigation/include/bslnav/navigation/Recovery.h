#pragma once

#include <bslnav/config/ConfigSection.h>
#include <mrpt/math/TPose2D.h>

#include <cstdint>

namespace bslnav {

struct RecoveryParameters {
  bool enabled = true;
  double patience_s = 1.5;  ///< blocked this long before anything is tried
  double stall_s = 8.0;     ///< no progress for this long counts as blocked
  double progressDistance_m =
      0.2;  ///< moving this far is progress; after backing off, this much farther than that
  double stepTimeout_s = 4.0;  ///< longest time for one step of a round
  double backOffDistance_m = 0.3;
  double backOffSpeed_mps = 0.1;
  int rounds = 3;  ///< rounds without progress before giving up

  void describe(ConfigSection& section);
};

/** What to do when the planner cannot go on: wait, then replan, turn towards the path, back off;
 * after some rounds give up.
 *
 * A state machine over time; it decides only which step is due. Progress starts it afresh. */
class Recovery {
 public:
  enum class Step : std::uint8_t { None, Replan, RotateToPath, BackOff, GiveUp };

  explicit Recovery(const RecoveryParameters& parameters) : parameters_(parameters) {}

  /** Called once a cycle while there is a goal.
   *  @param blocked the planner had no path or no admissible candidate in the cycle before
   *  @param stepDone the step that this returned in the cycle before is finished or cannot be done
   */
  Step update(double time_s, const mrpt::math::TPose2D& pose, bool blocked, bool stepDone);

  int round() const { return round_; }

  /** Forgets everything: after a new goal. */
  void reset() { *this = Recovery(parameters_); }

 private:
  void noteProgress(double time_s, const mrpt::math::TPose2D& pose);
  void enter(Step step, double time_s);

  RecoveryParameters parameters_;
  Step step_ = Step::None;
  int round_ = 0;
  bool started_ = false;
  double progressTime_s_ = 0.0, blockedSince_s_ = -1.0, stepSince_s_ = 0.0;
  mrpt::math::TPose2D progressPose_;
};

}  // namespace bslnav
