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
  /** A measurement that says nothing usable: the sensor is watched, but does not count as heard. */
  void refused(SensorKind kind, const std::string& label, const std::string& why);

  /** Age of the measurement of the sensor that is behind most; infinite before the first one. */
  double oldestAge_s(double now_s) const;
  /** That sensor in words, such as "laser 'front'"; "any sensor" when there is none. */
  std::string oldest() const;
  /** Why it is behind, in words: what was wrong with its last measurement, or that there was none.
   */
  std::string problemOfOldest() const;

 private:
  struct Sensor {
    SensorKind kind;
    std::string label;
    double newest_s;
    std::string problem;  // of its last measurement; empty if it was usable
  };
  Sensor& sensorOf(SensorKind kind, const std::string& label);
  const Sensor* oldestSensor() const;

  std::vector<Sensor> sensors_;
};

}  // namespace bslnav
