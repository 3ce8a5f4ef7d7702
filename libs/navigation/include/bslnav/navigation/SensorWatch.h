#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bslnav {

enum class SensorKind : std::uint8_t { Laser, Camera };

/** Remembers when each sensor was last heard of, so that one that falls silent is noticed while
 * others go on. */
class SensorWatch {
 public:
  /** A sensor that is to deliver; it is infinitely old until it does. */
  void expect(SensorKind kind, const std::string& label);

  /** A usable measurement of a sensor; a stamp ahead of `now_s` counts as now, so that it cannot
   * stay the newest for ever. */
  void heard(SensorKind kind, const std::string& label, double stamp_s, double now_s);

  /** Age of the measurement of the sensor that is behind most; infinite before the first one. */
  double oldestAge_s(double now_s) const;
  /** That sensor in words, such as "laser 'front'"; "any sensor" when there is none. */
  std::string oldest() const;

 private:
  struct Sensor {
    SensorKind kind;
    std::string label;
    double newest_s;
  };
  std::vector<Sensor> sensors_;
};

}  // namespace bslnav
