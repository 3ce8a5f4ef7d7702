#include "RawlogClock.h"

namespace bslnav {
namespace {

constexpr double kOutOfOrder_s = 0.5;  // how late a driver may deliver what another sensor overtook

}  // namespace

RawlogClock::Step RawlogClock::advance(std::optional<double> stamp_s, const std::string& sensor) {
  const bool sameSensor = sensor == sensor_;
  sensor_ = sensor;
  step_s_ = 0.0;
  if (!stamp_s) return Step::Missing;
  if (!startTime_s_) {
    startTime_s_ = *stamp_s - time_s_;
    return Step::Forward;
  }
  step_s_ = *stamp_s - (*startTime_s_ + time_s_);
  if (step_s_ < 0.0) {
    if (!sameSensor && step_s_ > -kOutOfOrder_s) return Step::None;
    startTime_s_ = *stamp_s - time_s_;
    return Step::Jump;
  }
  time_s_ = *stamp_s - *startTime_s_;
  if (step_s_ > gap_s_) return Step::Jump;
  return step_s_ > 0.0 ? Step::Forward : Step::None;
}

}  // namespace bslnav
