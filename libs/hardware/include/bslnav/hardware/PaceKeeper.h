#pragma once

#include <mrpt/math/TTwist2D.h>

#include <array>
#include <chrono>

namespace bslnav {

/** Keeps the pace of a control loop, and slows the robot down while the loop cannot. */
class PaceKeeper {
 public:
  explicit PaceKeeper(double period_s);

  /** Waits for the next cycle. Cycles that are missed are not made up for. */
  void wait();
  /** To be called when the cycle's command is sent. */
  void sent();

  /** The command as slow as the pace allows, on its arc. */
  mrpt::math::TTwist2D paced(const mrpt::math::TTwist2D& command) const;

  int cycles() const { return cycles_; }
  int misses() const { return misses_; }   ///< cycles that began or ended too late
  double share() const { return share_; }  ///< of the speed that is driven now
  double computing_s() const;              ///< the longest of the last cycles until sent()
  double worstLateness_s() const { return worst_s_; }  ///< of the begin of a cycle

 private:
  using Clock = std::chrono::steady_clock;

  void note(bool onTime);

  Clock::duration period_;
  Clock::time_point due_, begun_;
  int cycles_ = 0, misses_ = 0;
  double share_ = 1.0, worst_s_ = 0.0;
  std::array<double, 32> computing_s_{};
};

}  // namespace bslnav
