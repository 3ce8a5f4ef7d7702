#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace bslnav {

/** When a sensor measures, and when its measurements arrive; `Measurement` is a pointer type. */
template <typename Measurement>
class SensorSchedule {
 public:
  /** Measurement k is due at k / rate. */
  SensorSchedule(double rate_hz, double latency_s) : rate_hz_(rate_hz), latency_s_(latency_s) {}

  bool due(double time_s) const {
    return static_cast<double>(taken_) / rate_hz_ <= time_s + kTimeSlack_s;
  }

  /** Takes in the measurement that was due. */
  void take(Measurement measurement, double time_s) {
    arrive(time_s);
    pending_.push_back({time_s + latency_s_, std::move(measurement)});
    ++taken_;
  }

  /** The newest measurement that arrived since the last call; null when none did. */
  Measurement deliver(double time_s) {
    arrive(time_s);
    return std::exchange(arrived_, nullptr);
  }

 private:
  static constexpr double kTimeSlack_s = 1e-9;  // sums of substeps are not exact
  struct Pending {
    double arrival_s;
    Measurement measurement;
  };

  /** Older arrivals are let go: a run that never asks for measurements does not hoard them. */
  void arrive(double time_s) {
    const auto onItsWay =
        std::find_if(pending_.begin(), pending_.end(),
                     [time_s](const Pending& p) { return p.arrival_s > time_s + kTimeSlack_s; });
    if (onItsWay == pending_.begin()) return;
    arrived_ = std::move(std::prev(onItsWay)->measurement);
    pending_.erase(pending_.begin(), onItsWay);
  }

  double rate_hz_, latency_s_;
  long taken_ = 0;
  std::vector<Pending> pending_;
  Measurement arrived_;
};

/** What arrived from each sensor since the last call, in the sensors' order. */
template <typename Measurement, typename Sensors>
std::vector<Measurement> delivered(Sensors& sensors, double time_s) {
  std::vector<Measurement> measurements;
  for (auto& sensor : sensors)
    if (auto measurement = sensor.schedule.deliver(time_s))
      measurements.push_back(std::move(measurement));
  return measurements;
}

}  // namespace bslnav
