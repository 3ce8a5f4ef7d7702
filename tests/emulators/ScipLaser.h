#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ScipModel.h"

namespace bslnav::test {

/** A number in characters of six bits each, high bits first. */
std::string scipNumber(std::uint32_t value, int characters);

/** The laser's side of SCIP 2.0: commands in, answers and scans out; knows neither line nor clock.
 *
 *  Hokuyo, Communication Protocol Specification for SCIP2.0 Standard, C-42-03320B. Not there:
 *  scans of two characters (MS), single scans (GD, GS), clusters of steps, intensities (ME) and
 *  clock setting (TM). */
class ScipLaser {
 public:
  explicit ScipLaser(ScipModel model);

  /** Answers a command (without its line end), and does what it says. */
  std::string answer(std::string_view command);

  /** The mirror turns once: a scan's packet, or nothing when none is due.
   *  @param ranges_m one a step; infinite or out of range where there is nothing to measure */
  std::string turn(const std::vector<float>& ranges_m);

 private:
  std::string start(std::string_view command);
  std::string facts(std::string_view about) const;
  int code_mm(float range_m) const;

  ScipModel model_;
  bool laserOn_ = false;
  std::string scanCommand_;  // empty while not scanning
  int firstStep_ = 0, lastStep_ = 0, skip_ = 0, skipped_ = 0, left_ = 0;
  std::uint32_t clockStart_ms_;
  std::uint64_t turns_ = 0;  // since the clock's start
};

}  // namespace bslnav::test
