#include <bslnav/hardware/StampCheck.h>

#include <algorithm>
#include <cstdio>

namespace bslnav {
namespace {

std::string withSeconds(const char* format, double seconds) {
  char text[96];
  std::snprintf(text, sizeof(text), format, seconds);
  return text;
}

}  // namespace

void StampCheckParameters::describe(ConfigSection& section) {
  section.number("stamp_ahead_s", ahead_s, kNonNegative, "s",
                 "a measurement whose stamp is so far in the future is refused");
  section.number(
      "frozen_s", frozen_s, kNonNegative, "s",
      "a laser that repeats one scan for so long is frozen, and refused; 0: no laser is");
}

std::string StampCheck::refusal(double stamp_s, double now_s) {
  std::string why;
  if (stamp_s > now_s + parameters_.ahead_s)
    why = withSeconds("its clock is %.3f s ahead", stamp_s - now_s);
  else if (stamp_s <= newest_s_)
    why = withSeconds("its stamp is %.3f s before the last one", newest_s_ - stamp_s);
  if (!why.empty())
    ++refused_;
  else
    newest_s_ = stamp_s;
  return why;
}

std::string StampCheck::refusal(const mrpt::obs::CObservation2DRangeScan& scan, double stamp_s,
                                double now_s) {
  std::string why = refusal(stamp_s, now_s);
  if (!why.empty()) return why;
  const std::size_t count = scan.getScanSize();
  bool changed = count != ranges_.size();
  ranges_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const float range = scan.getScanRangeValidity(i) ? scan.getScanRange(i) : 0.0f;
    changed = changed || range != ranges_[i];
    ranges_[i] = range;
  }
  if (changed || changed_s_ < 0.0) changed_s_ = now_s;
  if (parameters_.frozen_s == 0.0 || now_s - changed_s_ <= parameters_.frozen_s) return {};
  ++refused_;
  return withSeconds("it has repeated one scan for %.1f s", now_s - changed_s_);
}

}  // namespace bslnav
