#pragma once

#include <functional>

namespace bslnav {

/** The time of a drive: a clock that never jumps, and what it is in MRPT's clock, which may. */
class DriveClock {
 public:
  /** Seconds of some clock. */
  using Source = std::function<double()>;

  DriveClock();
  /** @param steady never jumps; @param mrpts that of time stamps */
  DriveClock(Source steady, Source mrpts);

  /** Seconds since the start. */
  double time_s() const { return steady_() - start_s_; }
  /** What was time 0 in MRPT's clock, as that clock is now. */
  double startTime_s() const { return startTime_s_; }
  /** Looks at MRPT's clock; returns whether it jumped since the last time, by more than it could
   * have drifted. */
  bool followJumps();

 private:
  Source steady_, mrpts_;
  double start_s_, startTime_s_;
};

}  // namespace bslnav
