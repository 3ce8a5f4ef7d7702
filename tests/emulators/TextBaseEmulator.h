#pragma once

#include <bslnav/hardware/Base.h>
#include <bslnav/hardware/TextProtocol.h>

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace bslnav::test {

/** A microcontroller that speaks the text protocol (share/doc/base-protocol.md) 50 times a second,
 * in a thread of its own. What moves is somebody else's: it is told command() and tells setState().
 */
class TextBaseEmulator {
 public:
  enum class Wire { Serial, Tcp };

  explicit TextBaseEmulator(Wire wire = Wire::Serial);
  ~TextBaseEmulator();
  TextBaseEmulator(const TextBaseEmulator&) = delete;
  TextBaseEmulator& operator=(const TextBaseEmulator&) = delete;

  /** For TextBaseParameters::address. */
  const std::string& address() const { return address_; }

  /** What the wheels are to do; zero once the watchdog has expired. */
  mrpt::math::TTwist2D command() const;
  /** Whether the last line was a stop rather than a velocity. */
  bool stopped() const;
  /** What is told from now on; its stamp does not matter. */
  void setState(const BaseState& state);

  int hellos() const;   ///< those that it missed, too
  int refused() const;  ///< lines that were none

  // What goes wrong, from now on.
  void pullCable();                     ///< for good; done when it returns
  void send(const std::string& bytes);  ///< as they are, such as garbage or half a line
  void beSilent(bool silent);
  void beDeaf(bool deaf);      ///< reads nothing, so that the line fills up
  void missHellos(int count);  ///< as one that is still starting
  void tellNan(bool nan);      ///< poses whose x is "nan", with a right check sum
  void jumpClock(double seconds);
  /** Its clock begins anew and it waits for a hello. */
  void restart();
  /** Answers hello with this, instead of with what it was told. */
  void answerWith(const TextHello& hello);

  struct Line;

 private:
  using Clock = std::chrono::steady_clock;

  void run();
  void take(const std::string& bytes);
  void take(const TextMessage& message);
  std::string nextState();
  std::string stateLine() const;

  std::unique_ptr<Line> line_;
  std::string address_;

  mutable std::mutex mutex_;  // all below
  BaseState state_;
  TextLines lines_;
  mrpt::math::TTwist2D command_;
  Clock::time_point commanded_, nextState_, started_ = Clock::now();
  int watchdog_ms_ = 0, hellos_ = 0, toMiss_ = 0, refused_ = 0;
  bool greeted_ = false, stopped_ = false;
  bool ending_ = false, pulled_ = false, silent_ = false, deaf_ = false, nan_ = false;
  std::string toSend_;
  std::optional<TextHello> answer_;

  std::thread thread_;
};

/** Waits for something to become true, for five seconds at most. */
bool eventually(const std::function<bool()>& what);

}  // namespace bslnav::test
