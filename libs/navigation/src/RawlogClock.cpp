#include "RawlogClock.h"

namespace bslnav {
namespace {

constexpr double kOutOfOrder_s = 0.5;  // how late a driver may deliver what another sensor overtook

}  // namespace

bool RawlogClock::wentBack(double stamp_s, const std::string& sensor) const {
  if (step_s_ <= -kOutOfOrder_s) return true;
  const auto known = newest_s_.find(sensor);
  return known != newest_s_.end() && stamp_s < known->second;
}

RawlogClock::Step RawlogClock::advance(std::optional<double> stamp_s, const std::string& sensor) {
  step_s_ = 0.0;
  if (!stamp_s) return Step::Missing;
  const bool first = !startTime_s_;
  if (first) startTime_s_ = *stamp_s - time_s_;
  step_s_ = *stamp_s - (*startTime_s_ + time_s_);
  const bool back = wentBack(*stamp_s, sensor);
  if (back) newest_s_.clear();
  newest_s_[sensor] = *stamp_s;
  if (back) {
    startTime_s_ = *stamp_s - time_s_;
    return Step::Jump;
  }
  if (first) return Step::Forward;
  if (step_s_ <= 0.0) return Step::None;
  time_s_ = *stamp_s - *startTime_s_;
  return step_s_ > gap_s_ ? Step::Jump : Step::Forward;
}

}  // namespace bslnav
