#pragma once

#include <map>
#include <optional>
#include <string>

namespace bslnav {

/** Turns the time stamps of a log into a time that never decreases. */
class RawlogClock {
 public:
  enum class Step {
    Forward,
    None,     ///< no later than before
    Missing,  ///< no time stamp
    Jump      ///< back, or forward by more than the gap
  };

  explicit RawlogClock(double gap_s) : gap_s_(gap_s) {}

  /** @param stamp_s seconds since MRPT's epoch, if there is a time stamp
   *  @param sensor sensors may be logged slightly out of order, as when a camera takes longer to
   *  deliver than a laser; one sensor that goes back is a jump */
  Step advance(std::optional<double> stamp_s, const std::string& sensor);

  double time_s() const { return time_s_; }
  double startTime_s() const { return startTime_s_.value_or(0.0); }
  double step_s() const { return step_s_; }  ///< between the last two stamps, also when negative

 private:
  bool wentBack(double stamp_s, const std::string& sensor) const;

  double gap_s_;
  double time_s_ = 0.0, step_s_ = 0.0;
  std::optional<double> startTime_s_;
  std::map<std::string, double> newest_s_;  // stamp of every sensor, since the clock last went back
};

}  // namespace bslnav
