#include <bslnav/hardware/DriveClock.h>
#include <mrpt/core/Clock.h>

#include <chrono>
#include <cmath>
#include <utility>

namespace bslnav {
namespace {

constexpr double kJump_s = 0.05;

double steadyNow_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

DriveClock::DriveClock() : DriveClock(steadyNow_s, [] { return mrpt::Clock::nowDouble(); }) {}

DriveClock::DriveClock(Source steady, Source mrpts)
    : steady_(std::move(steady)),
      mrpts_(std::move(mrpts)),
      start_s_(steady_()),
      startTime_s_(mrpts_()) {}

bool DriveClock::followJumps() {
  const double now_s = mrpts_() - time_s();
  const bool jumped = std::abs(now_s - startTime_s_) > kJump_s;
  startTime_s_ = now_s;  // also where it drifts
  return jumped;
}

}  // namespace bslnav
