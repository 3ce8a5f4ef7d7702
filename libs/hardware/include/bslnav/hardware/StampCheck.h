#pragma once

#include <bslnav/config/ConfigSection.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <string>
#include <vector>

namespace bslnav {

struct StampCheckParameters {
  double ahead_s = 0.05;  ///< a stamp so far in the future is wrong
  double frozen_s = 0.5;  ///< a laser that repeats one scan for so long is frozen; 0: never

  void describe(ConfigSection& section);
};

/** Tells which measurements of one sensor can be believed to be new. */
class StampCheck {
 public:
  explicit StampCheck(const StampCheckParameters& parameters) : parameters_(parameters) {}

  /** Why a measurement is refused, in words; empty: it is not.
   *  @param stamp_s,now_s of one clock */
  std::string refusal(double stamp_s, double now_s);
  /** The same for a scan, which must not repeat the one before, to the last bit, for too long: real
   * ranges have noise. */
  std::string refusal(const mrpt::obs::CObservation2DRangeScan& scan, double stamp_s, double now_s);

  int refused() const { return refused_; }

 private:
  StampCheckParameters parameters_;
  double newest_s_ = -1.0, changed_s_ = -1.0;
  std::vector<float> ranges_;
  int refused_ = 0;
};

}  // namespace bslnav
