#pragma once

#include <bslnav/config/Error.h>
#include <bslnav/hardware/Base.h>
#include <bslnav/hardware/DeviceClock.h>
#include <bslnav/hardware/TextProtocol.h>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace bslnav {

class ConfigSection;
class DeviceLine;

struct TextBaseParameters {
  std::string address = "/dev/ttyACM0";  ///< or tcp:HOST:PORT
  int baud = 115200;
  double watchdog_s = 0.3;
  double start_s = 1.0;

  void describe(ConfigSection& section);
};

/** What came over the line since it was opened. */
struct TextLineCounts {
  int states = 0;
  int refused = 0;  ///< lines that were cut, damaged or not of the protocol
};

/** A microcontroller that speaks the text protocol of share/doc/base-protocol.md. */
class TextBase : public Base {
 public:
  /** Opens the line, says hello and waits for the first state.
   *  @throws Error (Run) when the line cannot be opened or nothing fitting comes within start_s,
   *  (Configuration) for an address that is none */
  explicit TextBase(const TextBaseParameters& parameters);
  ~TextBase() override;
  TextBase(const TextBase&) = delete;
  TextBase& operator=(const TextBase&) = delete;

  BaseState state() override;
  /** @throws Error (Run) also for a command that is not finite (the base is stopped then), and when
   * the base takes no more lines */
  void drive(const mrpt::math::TTwist2D& command) override;
  void stop() noexcept override;

  TextLineCounts counts() const;

 private:
  void greet();
  bool waitForGreeting(double timeout_s);
  void finish() noexcept;
  void send(const TextMessage& message);
  void readLines() noexcept;
  void take(const std::string& bytes, double now_s);
  void take(const TextMessage& message, double now_s);

  TextBaseParameters parameters_;
  std::unique_ptr<DeviceLine> line_;

  std::mutex writing_;
  bool cutShort_ = true;  // the base may hold the beginning of a line that was never ended

  mutable std::mutex reading_;  // all below
  std::condition_variable heard_;
  bool ending_ = false;
  std::optional<Error> gone_;
  std::optional<TextHello> hello_;
  std::optional<BaseState> state_;
  TextLines lines_;
  DeviceClock clock_;
  TextLineCounts counts_;

  std::thread reader_;
};

}  // namespace bslnav
