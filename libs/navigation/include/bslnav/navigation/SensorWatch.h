#pragma once

#include <string>
#include <vector>

namespace bslnav {

/** Remembers when each sensor was last heard of, so that one that falls silent is noticed while
 * others go on. */
class SensorWatch {
 public:
  /** A sensor that is to deliver; it is infinitely old until it does. */
  void expect(const std::string& sensor);

  /** A usable measurement of a sensor; a stamp ahead of `now_s` counts as now, so that it cannot
   * stay the newest for ever. */
  void heard(const std::string& sensor, double stamp_s, double now_s);

  /** Age of the measurement of the sensor that is behind most; infinite before the first one. */
  double oldestAge_s(double now_s) const;
  /** The label of that sensor; empty when there is none. */
  std::string oldest() const;

 private:
  struct Sensor {
    std::string label;
    double newest_s;
  };
  std::vector<Sensor> sensors_;
};

}  // namespace bslnav
