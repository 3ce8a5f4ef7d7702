#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace bslnav {

/** A serial line or a TCP connection to a device; no call takes longer than it is told.
 *
 * MRPT opens and configures the line. Its own functions do not read and write here, because
 * they wait for ever for a device that takes nothing (CSerialPort::Write, tcdrain), end the program
 * by SIGPIPE or go round and round when the device has hung up (CClientTCPSocket::writeAsync), and
 * close the file in one thread while another may be using it.
 *
 * One thread may read while another writes. */
class DeviceLine {
 public:
  /** @param address a serial device, such as "/dev/ttyACM0", or "tcp:HOST:PORT"
   *  @throws Error (Configuration) for an address that is none, (Run) when it cannot be opened */
  static std::unique_ptr<DeviceLine> open(const std::string& address, int baud);

  virtual ~DeviceLine() = default;

  /** What came within a time, at most; empty when nothing did. @throws Error (Run) when it is gone
   */
  std::string read(double timeout_s);

  /** How many of the bytes the line took within a time. @throws Error (Run) when it is gone */
  std::size_t write(std::string_view bytes, double timeout_s);

 protected:
  explicit DeviceLine(const std::string& address) : address_(address) {}

 private:
  virtual int file() const = 0;
  virtual bool isSocket() const = 0;
  [[noreturn]] void gone(int error) const;

  std::string address_;
};

}  // namespace bslnav
