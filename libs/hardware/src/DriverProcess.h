#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

namespace bslnav {

/** A process of bslnav-sensor: reads its section when it starts, then writes messages. */
class DriverProcess {
 public:
  /** @param ini the configuration that it reads; @param logFile gets what it prints; empty: nobody
   *  does
   *  @throws std::runtime_error when it cannot be started */
  DriverProcess(const std::string& program, const std::string& section, const std::string& ini,
                const std::string& logFile);
  ~DriverProcess() { end(); }
  DriverProcess(const DriverProcess&) = delete;
  DriverProcess& operator=(const DriverProcess&) = delete;

  pid_t id() const { return process_; }
  /** What it wrote within a time, at most; none: it writes no more. */
  std::optional<std::string> read(double timeout_s) const;
  /** Ends it, the hard way if it does not end within half a second; returns how it ended, in words.
   */
  std::string end();

 private:
  pid_t process_ = -1;
  int messages_ = -1;
};

}  // namespace bslnav
