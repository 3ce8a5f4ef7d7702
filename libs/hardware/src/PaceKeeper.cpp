#include <bslnav/hardware/PaceKeeper.h>

#include <algorithm>
#include <thread>

namespace bslnav {
namespace {

constexpr double kSlower = 0.7, kLeast = 0.3, kFaster = 0.02;  // of the share, cycle by cycle
constexpr double kLate = 0.5;  // of a period: a cycle that begins so late is missed

double seconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

PaceKeeper::PaceKeeper(double period_s)
    : period_(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(period_s))),
      due_(Clock::now()),
      begun_(due_) {}

void PaceKeeper::wait() {
  std::this_thread::sleep_until(due_);
  begun_ = Clock::now();
  const double late_s = seconds(begun_ - due_);
  worst_s_ = std::max(worst_s_, late_s);
  note(late_s <= kLate * seconds(period_));
  due_ = std::max(due_ + period_, begun_);
}

void PaceKeeper::sent() {
  computing_s_[static_cast<std::size_t>(cycles_++) % computing_s_.size()] =
      seconds(Clock::now() - begun_);
}

void PaceKeeper::note(bool onTime) {
  if (onTime) {
    share_ = std::min(1.0, share_ + kFaster);
    return;
  }
  ++misses_;
  share_ = std::max(kLeast, share_ * kSlower);
}

mrpt::math::TTwist2D PaceKeeper::paced(const mrpt::math::TTwist2D& command) const {
  return {command.vx * share_, command.vy * share_, command.omega * share_};
}

double PaceKeeper::computing_s() const {
  return *std::max_element(computing_s_.begin(), computing_s_.end());
}

}  // namespace bslnav
