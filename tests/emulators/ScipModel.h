#pragma once

#include <bslnav/simulation/LaserSensor.h>

#include <cstdint>
#include <string>

namespace bslnav::test {

/** What a laser of the SCIP 2.0 family says of itself; defaults: UTM-30LX. */
struct ScipModel {
  std::string name = "UTM-30LX";
  int minRange_mm = 23, maxRange_mm = 30000;
  int nothingCode = 1, tooNearCode = 4;  ///< what beams without a range carry instead
  int stepsPerTurn = 1440, firstStep = 0, lastStep = 1080, frontStep = 540;
  int speed_rpm = 2400;
  std::uint32_t clockAtStart_ms = 0;  ///< of 24 bits: it wraps every 4.66 hours

  static ScipModel urg04lx();

  int beams() const { return lastStep - firstStep + 1; }
  double period_s() const { return 60.0 / speed_rpm; }
  /** Where a step looks: counterclockwise from straight ahead. */
  double angle_rad(int step) const;
  /** The exact laser of the simulator whose beams are this one's steps, first to last. */
  LaserParameters simulated() const;
};

}  // namespace bslnav::test
