#include <bslnav/navigation/SensorWatch.h>

#include <algorithm>
#include <limits>

namespace bslnav {

void SensorWatch::expect(SensorKind kind, const std::string& label) {
  sensors_.push_back({kind, label, -std::numeric_limits<double>::infinity()});
}

void SensorWatch::heard(SensorKind kind, const std::string& label, double stamp_s, double now_s) {
  const double heard_s = std::min(stamp_s, now_s);
  for (auto& known : sensors_)
    if (known.kind == kind && known.label == label) {
      known.newest_s = std::max(known.newest_s, heard_s);
      return;
    }
  sensors_.push_back({kind, label, heard_s});
}

double SensorWatch::oldestAge_s(double now_s) const {
  double oldest = sensors_.empty() ? std::numeric_limits<double>::infinity() : 0.0;
  for (const auto& sensor : sensors_) oldest = std::max(oldest, now_s - sensor.newest_s);
  return oldest;
}

std::string SensorWatch::oldest() const {
  const auto oldest =
      std::min_element(sensors_.begin(), sensors_.end(),
                       [](const Sensor& a, const Sensor& b) { return a.newest_s < b.newest_s; });
  if (oldest == sensors_.end()) return "any sensor";
  return (oldest->kind == SensorKind::Laser ? "laser '" : "camera '") + oldest->label + "'";
}

}  // namespace bslnav
