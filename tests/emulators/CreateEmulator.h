#pragma once

#include <PseudoTerminal.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <thread>

#include "CreateRobot.h"

namespace bslnav::test {

/** A Create 2 at the other end of a serial line, in real time, with a line that can be disturbed.
 *
 * It has wheels but no world: who simulates one asks for wheels() and tells what they moved(). All
 * functions may be called from any thread. */
class CreateEmulator {
 public:
  using Wheels = CreateRobot::Wheels;
  struct Drive {
    Wheels wheels;
    std::chrono::steady_clock::time_point at;
    std::size_t count = 0;  ///< commands so far
  };

  /** @param seed of the garbage */
  explicit CreateEmulator(std::unique_ptr<PseudoTerminal> line = std::make_unique<PseudoTerminal>(),
                          std::uint32_t seed = 1);
  ~CreateEmulator();
  CreateEmulator(const CreateEmulator&) = delete;
  CreateEmulator& operator=(const CreateEmulator&) = delete;

  /** What a driver opens. */
  const std::string& path() const { return line_->path(); }

  /** As commanded; zero in passive mode. */
  Wheels wheels() const;
  /** The newest Drive Direct, obeyed or not. */
  Drive lastDrive() const;
  CreateRobot::Mode mode() const;

  void moved(double left_m, double right_m);
  void setBump(bool pressed);
  void setCliff(bool seen);
  void setWheelDrop(bool dropped);

  /** For good. The robot drives on, as a real one does. */
  void pullCable();
  /** Random bytes before the next frame. */
  void sendGarbage(std::size_t count);
  void halveNextFrame();
  /** Alters a value of the next frame on its way. */
  void damageNextFrame();
  /** No frames; commands are obeyed. */
  void goSilent(bool silent);

 private:
  void run();
  void obey(const std::string& bytes);
  std::string nextBytes();

  std::unique_ptr<PseudoTerminal> line_;  // the thread's own
  mutable std::mutex mutex_;              // for all below
  CreateRobot robot_;
  Drive drive_;
  std::mt19937 random_;
  std::size_t garbage_ = 0;
  bool halve_ = false, damage_ = false, silent_ = false;
  std::atomic<bool> pulled_{false}, ending_{false};
  std::thread thread_;
};

}  // namespace bslnav::test
