#include "TcpServerLine.h"

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace bslnav::test {
namespace {

constexpr int kSmallBuffer = 4096;  // so that a client notices soon when nobody reads

bool isReadable(int file, double timeout_s) {
  pollfd waited{file, POLLIN, 0};
  return ::poll(&waited, 1, static_cast<int>(1e3 * timeout_s)) > 0;
}

void closeFile(int& file) {
  if (file >= 0) ::close(file);
  file = -1;
}

}  // namespace

TcpServerLine::TcpServerLine() : listening_(::socket(AF_INET, SOCK_STREAM, 0)) {
  sockaddr_in where{};
  where.sin_family = AF_INET;
  where.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof(where);
  auto* address = reinterpret_cast<sockaddr*>(&where);
  ::setsockopt(listening_, SOL_SOCKET, SO_RCVBUF, &kSmallBuffer, sizeof(kSmallBuffer));
  if (listening_ < 0 || ::bind(listening_, address, length) != 0 || ::listen(listening_, 1) != 0 ||
      ::getsockname(listening_, address, &length) != 0)
    throw std::system_error(errno, std::generic_category(), "a TCP server");
  address_ = "tcp:127.0.0.1:" + std::to_string(ntohs(where.sin_port));
}

TcpServerLine::~TcpServerLine() { hangUp(); }

std::string TcpServerLine::read(double timeout_s) {
  const bool connected = client_ >= 0;
  if (!isReadable(connected ? client_ : listening_, timeout_s)) return {};
  if (!connected) {
    client_ = ::accept(listening_, nullptr, nullptr);
    return {};
  }
  std::array<char, 4096> bytes{};
  const auto count = ::recv(client_, bytes.data(), bytes.size(), MSG_DONTWAIT);
  if (count > 0) return {bytes.data(), static_cast<std::size_t>(count)};
  if (count == 0 || errno != EAGAIN) closeFile(client_);
  return {};
}

bool TcpServerLine::write(std::string_view bytes) {
  if (client_ < 0) return false;
  const auto count = ::send(client_, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  return count == static_cast<ssize_t>(bytes.size());
}

void TcpServerLine::hangUp() {
  closeFile(client_);
  closeFile(listening_);
}

}  // namespace bslnav::test
