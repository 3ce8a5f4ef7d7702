#include <bslnav/config/Error.h>
#include <mrpt/comms/CClientTCPSocket.h>
#include <mrpt/comms/CSerialPort.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <charconv>
#include <chrono>
#include <cstdint>
#include <thread>

#include "DeviceLine.h"

namespace bslnav {
namespace {

constexpr unsigned kConnect_ms = 1000;
constexpr auto kDrain = std::chrono::milliseconds(100);

class SerialLine final : public DeviceLine, private mrpt::comms::CSerialPort {
 public:
  SerialLine(const std::string& address, int baud) : DeviceLine(address) {
    CSerialPort::open(address);
    setConfig(baud);
  }

  /** The kernel waits half a minute for a device that does not take what is left, so that is
   * dropped after a while. */
  ~SerialLine() override {
    const auto until = std::chrono::steady_clock::now() + kDrain;
    int left = 0;
    while (::ioctl(hCOM, TIOCOUTQ, &left) == 0 && left > 0 &&
           std::chrono::steady_clock::now() < until)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (left > 0) ::tcflush(hCOM, TCOFLUSH);
  }

 private:
  int file() const override { return hCOM; }
  bool isSocket() const override { return false; }
};

class TcpLine final : public DeviceLine, private mrpt::comms::CClientTCPSocket {
 public:
  TcpLine(const std::string& address, const std::string& host, std::uint16_t port)
      : DeviceLine(address) {
    connect(host, port, kConnect_ms);
    setTCPNoDelay(1);  // a command does not wait for the next one
  }

 private:
  int file() const override { return m_hSock; }
  bool isSocket() const override { return true; }
};

std::unique_ptr<DeviceLine> openTcp(const std::string& address) {
  const auto colon = address.rfind(':');
  const std::string host = colon < 4 ? "" : address.substr(4, colon - 4);
  std::uint16_t port = 0;
  const char* end = address.data() + address.size();
  const auto [parsed, error] = std::from_chars(address.data() + colon + 1, end, port);
  if (host.empty() || error != std::errc() || parsed != end || port == 0)
    throw Error(address, "is no address; expected tcp:HOST:PORT");
  try {
    return std::make_unique<TcpLine>(address, host, port);
  } catch (const std::exception&) {  // its text is MRPT's source line and a backtrace
    throw Error(address, "cannot be connected; expected a device that listens there",
                Error::Kind::Run);
  }
}

}  // namespace

std::unique_ptr<DeviceLine> DeviceLine::open(const std::string& address, int baud) {
  if (address.rfind("tcp:", 0) == 0) return openTcp(address);
  try {
    return std::make_unique<SerialLine>(address, baud);
  } catch (const std::exception&) {
    throw Error(address,
                "cannot be opened with " + std::to_string(baud) +
                    " baud; expected a serial device that you may read and write (often: be in "
                    "the group dialout)",
                Error::Kind::Run);
  }
}

}  // namespace bslnav
