#pragma once

#include <cstdint>
#include <optional>

namespace bslnav {

/** Tells when something was measured from the clock of the device that measured it, which knows
 * nothing of ours.
 *
 * What arrived soonest gives the difference of the clocks, as it was on its way the shortest. The
 * difference may grow by `kDrift` of the time that passes, since no two clocks go alike. A stamp is
 * never later than `now_s`. */
class DeviceClock {
 public:
  /** @param device_ms the device's clock, which may overflow, jump or begin anew
   *  @param now_s when this arrived, in the clock that the stamp is wanted in */
  double stamp_s(std::uint32_t device_ms, double now_s);

 private:
  static constexpr double kDrift = 0.005;  // as much as a ceramic resonator is off
  static constexpr double kDelay_s = 1.0;  // what arrives later than that was delayed, or the
  static constexpr double kBelieve_s =
      0.5;  // device's clock jumped: it stays so for longer than this

  bool jumpedBack(std::int32_t step_ms, double now_s);

  struct Fit {
    std::uint32_t device_ms;
    double device_s;      // since the first, without overflows
    double difference_s;  // ours minus the device's
  };
  std::optional<Fit> fit_;
  std::optional<double> lateSince_s_;
};

}  // namespace bslnav
