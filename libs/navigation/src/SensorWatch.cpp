#include <bslnav/navigation/SensorWatch.h>

#include <algorithm>
#include <limits>

namespace bslnav {

void SensorWatch::expect(SensorKind kind, const std::string& label) {
  sensors_.push_back({kind, label, -std::numeric_limits<double>::infinity(), {}});
}

void SensorWatch::heard(SensorKind kind, const std::string& label, double stamp_s, double now_s) {
  const double heard_s = std::min(stamp_s, now_s);
  Sensor& sensor = sensorOf(kind, label);
  sensor.newest_s = std::max(sensor.newest_s, heard_s);
  sensor.problem.clear();
}

void SensorWatch::refused(SensorKind kind, const std::string& label, const std::string& why) {
  sensorOf(kind, label).problem = why;
}

SensorWatch::Sensor& SensorWatch::sensorOf(SensorKind kind, const std::string& label) {
  for (auto& known : sensors_)
    if (known.kind == kind && known.label == label) return known;
  expect(kind, label);
  return sensors_.back();
}

double SensorWatch::oldestAge_s(double now_s) const {
  double oldest = sensors_.empty() ? std::numeric_limits<double>::infinity() : 0.0;
  for (const auto& sensor : sensors_) oldest = std::max(oldest, now_s - sensor.newest_s);
  return oldest;
}

std::string SensorWatch::problemOfOldest() const {
  const Sensor* sensor = oldestSensor();
  if (!sensor || sensor->problem.empty()) return "nothing new from " + oldest();
  return sensor->problem;
}

std::string SensorWatch::oldest() const {
  const Sensor* sensor = oldestSensor();
  if (!sensor) return "any sensor";
  return (sensor->kind == SensorKind::Laser ? "laser '" : "camera '") + sensor->label + "'";
}

const SensorWatch::Sensor* SensorWatch::oldestSensor() const {
  const auto oldest =
      std::min_element(sensors_.begin(), sensors_.end(),
                       [](const Sensor& a, const Sensor& b) { return a.newest_s < b.newest_s; });
  return oldest == sensors_.end() ? nullptr : &*oldest;
}

}  // namespace bslnav
