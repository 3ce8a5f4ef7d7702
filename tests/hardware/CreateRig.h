#pragma once

#include <CreateEmulator.h>
#include <bslnav/hardware/CreateBase.h>

#include <chrono>
#include <functional>
#include <string>
#include <thread>

namespace bslnav::test {

/** Whether it comes true before long: seconds on a machine with other work to do. */
inline bool eventually(
    const std::function<bool()>& condition, const std::function<void()>& meanwhile = [] {}) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > until) return false;
    meanwhile();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

inline CreateParameters createAt(const std::string& path) {
  CreateParameters parameters;
  parameters.port = path;
  return parameters;
}

inline CreateParameters patientCreateAt(const std::string& path) {
  CreateParameters parameters = createAt(path);
  parameters.commandTimeout_s = 60.0;
  return parameters;
}

/** A robot and its driver. */
struct CreateRig {
  CreateEmulator robot;
  CreateBase base{createAt(robot.path())};

  bool stands() const { return robot.wheels().left_mps == 0.0 && robot.wheels().right_mps == 0.0; }
  double speed_mps() const { return 0.5 * (robot.wheels().left_mps + robot.wheels().right_mps); }

  /** Commands again and again, until it comes true. */
  bool driveUntil(const mrpt::math::TTwist2D& command, const std::function<bool()>& condition) {
    return eventually(condition, [&] { base.drive(command); });
  }
};

}  // namespace bslnav::test
