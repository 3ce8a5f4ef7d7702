#include "DeviceLine.h"

#include <bslnav/config/Error.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <system_error>

namespace bslnav {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kBroken = POLLERR | POLLHUP | POLLNVAL;

/** What happened to a file; 0: nothing within the time. A signal begins the wait anew. */
int waitFor(int file, short events, double timeout_s) {
  pollfd waited{file, events, 0};
  const auto timeout_ms = static_cast<int>(std::ceil(1e3 * std::max(timeout_s, 0.0)));
  int count = -1;
  do count = ::poll(&waited, 1, timeout_ms);
  while (count < 0 && errno == EINTR);
  return count > 0 ? waited.revents : 0;
}

bool mayTryAgain(int error) { return error == EAGAIN || error == EWOULDBLOCK || error == EINTR; }

}  // namespace

std::string DeviceLine::read(double timeout_s) {
  const int events = waitFor(file(), POLLIN, timeout_s);
  if (events == 0) return {};
  std::array<char, 4096> bytes{};
  const auto count = isSocket() ? ::recv(file(), bytes.data(), bytes.size(), MSG_DONTWAIT)
                                : ::read(file(), bytes.data(), bytes.size());
  if (count > 0) return {bytes.data(), static_cast<std::size_t>(count)};
  if (count < 0 && !mayTryAgain(errno)) gone(errno);
  if (count == 0 && (isSocket() || (events & kBroken) != 0)) gone(0);
  return {};
}

std::size_t DeviceLine::write(std::string_view bytes, double timeout_s) {
  const auto until = Clock::now() + std::chrono::duration<double>(timeout_s);
  std::size_t written = 0;
  do {  // once at least: a busy machine may have used up the time
    const double left_s = std::chrono::duration<double>(until - Clock::now()).count();
    if (waitFor(file(), POLLOUT, left_s) == 0) break;
    const char* rest = bytes.data() + written;
    const auto count =
        isSocket() ? ::send(file(), rest, bytes.size() - written, MSG_DONTWAIT | MSG_NOSIGNAL)
                   : ::write(file(), rest, bytes.size() - written);
    if (count < 0 && !mayTryAgain(errno)) gone(errno);
    if (count > 0) written += static_cast<std::size_t>(count);
  } while (written < bytes.size() && Clock::now() < until);
  return written;
}

void DeviceLine::gone(int error) const {
  const std::string why = error == 0 ? "hung up" : std::generic_category().message(error);
  throw Error(address_, "the line is gone (" + why + ")", Error::Kind::Run);
}

}  // namespace bslnav
