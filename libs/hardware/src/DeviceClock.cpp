#include <bslnav/hardware/DeviceClock.h>

#include <algorithm>

namespace bslnav {

double DeviceClock::stamp_s(std::uint32_t device_ms, double now_s) {
  if (!fit_) fit_ = {device_ms, 0.0, now_s};
  const auto step_ms = static_cast<std::int32_t>(device_ms - fit_->device_ms);
  fit_->device_ms = device_ms;
  fit_->device_s += 1e-3 * step_ms;
  const double apart_s = now_s - fit_->device_s;
  if (jumpedBack(step_ms, now_s))
    fit_->difference_s = apart_s;
  else
    fit_->difference_s = std::min(fit_->difference_s + 1e-3 * step_ms * kDrift, apart_s);
  return std::min(fit_->device_s + fit_->difference_s, now_s);
}

bool DeviceClock::jumpedBack(std::int32_t step_ms, double now_s) {
  const double delay_s = now_s - fit_->device_s - fit_->difference_s;
  const bool late = step_ms >= 0 && delay_s > kDelay_s;
  if (!late) lateSince_s_.reset();
  if (late && !lateSince_s_) lateSince_s_ = now_s;
  const bool jumped = step_ms < 0 || (late && now_s - *lateSince_s_ > kBelieve_s);
  if (jumped) lateSince_s_.reset();
  return jumped;
}

}  // namespace bslnav
