#pragma once

#include <bslnav/hardware/Base.h>

#include <array>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace bslnav {

/** Stops a base when the control loop, the sensors or the pose have not been heard of for too long,
 * from a thread of its own: whatever the loop does. */
class Watchdog {
 public:
  enum class Source { Loop, Sensors, Pose };
  struct Limits {
    double loop_s = 0.25, sensors_s = 1.0, pose_s = 1.0;
  };

  /** All count as heard now. @param base outlives this object */
  Watchdog(Base& base, const Limits& limits);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  void heard(Source source);
  /** Who was silent, in words, since the last call, if the base was stopped for it; else empty. */
  std::string tripped();
  int trips() const;

 private:
  void watch();
  bool isLate(std::string* who) const;

  Base& base_;
  std::array<double, 3> limits_s_, heard_s_;
  mutable std::mutex mutex_;
  std::condition_variable endingChanged_;
  bool ending_ = false, late_ = false;
  std::string tripped_;
  int trips_ = 0;
  std::thread thread_;
};

}  // namespace bslnav
