#pragma once

#include <string>
#include <string_view>

namespace bslnav::test {

/** A TCP server for one client at a time: what a driver connects to at address() is read and
 * written here. */
class TcpServerLine {
 public:
  /** Listens at a port of this machine that is free. @throws std::system_error when it cannot */
  TcpServerLine();
  ~TcpServerLine();
  TcpServerLine(const TcpServerLine&) = delete;
  TcpServerLine& operator=(const TcpServerLine&) = delete;

  /** What a driver connects to, such as tcp:127.0.0.1:40123. */
  const std::string& address() const { return address_; }

  /** What came within a time, at most; empty when nothing did. */
  std::string read(double timeout_s);
  /** Whether there is a client that takes it. */
  bool write(std::string_view bytes);

  /** Hangs up, and listens no more. Nothing undoes that. */
  void hangUp();

 private:
  int listening_ = -1, client_ = -1;
  std::string address_;
};

}  // namespace bslnav::test
