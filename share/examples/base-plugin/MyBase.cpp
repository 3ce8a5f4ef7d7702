// A base that does exactly what it is told: replace what is in state(), drive() and stop() by what your base needs.
#include <bslnav/config/Error.h>
#include <bslnav/hardware/BasePlugin.h>
#include <mrpt/core/Clock.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <mutex>

class MyBase : public bslnav::Base {
 public:
  explicit MyBase(const std::map<std::string, std::string>& options) {
    for (const auto& [key, text] : options) {
      const char* end = text.data() + text.size();
      const auto result = std::from_chars(text.data(), end, maxSpeed_mps_);
      if (key != "max_speed_mps" || result.ptr != end || !(maxSpeed_mps_ > 0.0))
        throw bslnav::Error("option " + key + " = " + text, "expected max_speed_mps = a number above 0");
    }
  }

  bslnav::BaseState state() override {
    const std::lock_guard lock(mutex_);
    integrate();
    return state_;
  }

  void drive(const mrpt::math::TTwist2D& command) override {
    const std::lock_guard lock(mutex_);
    integrate();
    const double slower = maxSpeed_mps_ / std::max(std::hypot(command.vx, command.vy), maxSpeed_mps_);
    state_.twist = {slower * command.vx, slower * command.vy, slower * command.omega};  // on the same arc
    driveUntil_s_ = state_.stamp_s + kWatchdog_s;
  }

  void stop() noexcept override {
    const std::lock_guard lock(mutex_);
    integrate();
    state_.twist = {};
  }

 private:
  static constexpr double kWatchdog_s = 0.3;

  void integrate() {
    const double now_s = mrpt::Clock::nowDouble();
    const double time_s = std::max(0.0, std::min(now_s, driveUntil_s_) - state_.stamp_s);
    const auto& [vx, vy, omega] = state_.twist;
    const double turn = omega * time_s, half = turn / 2;
    const double chord_s = time_s * (half == 0.0 ? 1.0 : std::sin(half) / half);  // an arc's chord: half way round
    auto& pose = state_.odometry;
    pose.x += chord_s * (vx * std::cos(pose.phi + half) - vy * std::sin(pose.phi + half));
    pose.y += chord_s * (vx * std::sin(pose.phi + half) + vy * std::cos(pose.phi + half));
    pose.phi = std::remainder(pose.phi + turn, 2 * M_PI);
    if (now_s > driveUntil_s_) state_.twist = {};
    state_.stamp_s = now_s;
  }

  std::mutex mutex_;
  double maxSpeed_mps_ = 1.0, driveUntil_s_ = 0.0;
  bslnav::BaseState state_;
};

BSLNAV_BASE_PLUGIN(MyBase);
