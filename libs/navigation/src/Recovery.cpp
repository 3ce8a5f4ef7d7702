#include <bslnav/navigation/Recovery.h>

#include <cmath>

namespace bslnav {

void RecoveryParameters::describe(ConfigSection& section) {
  section.flag(
      "enabled", enabled,
      "whether to turn, back off and give up when blocked; otherwise the robot waits for ever");
  section.number("patience_s", patience_s, kNonNegative, "s",
                 "blocked this long before anything is tried");
  section.number("stall_s", stall_s, kPositive, "s", "no progress for this long counts as blocked");
  section.number("progress_distance_m", progressDistance_m, kPositive, "m",
                 "moving this far is progress");
  section.number("step_timeout_s", stepTimeout_s, kPositive, "s", "longest time for one step");
  section.number("back_off_distance_m", backOffDistance_m, kNonNegative, "m",
                 "how far to back off");
  section.number("back_off_speed_mps", backOffSpeed_mps, {0.01, 1.0}, "m/s",
                 "how fast to back off");
  section.integer("rounds", rounds, {0, 1000}, "", "rounds without progress before giving up");
}

void Recovery::enter(Step step, double time_s) {
  step_ = step;
  stepSince_s_ = time_s;
}

void Recovery::noteProgress(double time_s, const mrpt::math::TPose2D& pose) {
  if (step_ != Step::None) return;
  // Coming back to where it was blocked is no progress: it has to get farther than backing off
  // brings it.
  const double enough = parameters_.progressDistance_m + round_ * parameters_.backOffDistance_m;
  const double moved = std::hypot(pose.x - progressPose_.x, pose.y - progressPose_.y);
  if (started_ && moved < enough) return;
  round_ = 0;
  started_ = true;
  progressPose_ = pose;
  progressTime_s_ = time_s;
}

Recovery::Step Recovery::update(double time_s, const mrpt::math::TPose2D& pose, bool blocked,
                                bool stepDone) {
  noteProgress(time_s, pose);
  if (!parameters_.enabled || step_ == Step::GiveUp) return step_;

  if (step_ != Step::None) {
    if (!stepDone && time_s - stepSince_s_ < parameters_.stepTimeout_s) return step_;
    const Step next[] = {Step::None, Step::RotateToPath, Step::BackOff,
                         Step::None};  // after None, Replan, Rotate, BackOff
    enter(next[static_cast<int>(step_)], time_s);
    if (step_ == Step::None) {
      progressTime_s_ = time_s;
      blockedSince_s_ = -1.0;
    }
    return step_;
  }

  if (!blocked)
    blockedSince_s_ = -1.0;
  else if (blockedSince_s_ < 0.0)
    blockedSince_s_ = time_s;
  const bool outOfPatience =
      blockedSince_s_ >= 0.0 && time_s - blockedSince_s_ >= parameters_.patience_s;
  if (!outOfPatience && time_s - progressTime_s_ < parameters_.stall_s) return Step::None;
  enter(round_ >= parameters_.rounds ? Step::GiveUp : Step::Replan, time_s);
  ++round_;
  return step_;
}

}  // namespace bslnav
