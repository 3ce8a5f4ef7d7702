#include "PseudoTerminal.h"

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <system_error>

namespace bslnav::test {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

bool waitFor(int file, short events, double timeout_s) {
  pollfd waited{file, events, 0};
  return ::poll(&waited, 1, static_cast<int>(1e3 * timeout_s)) > 0 &&
         (waited.revents & events) != 0;
}

}  // namespace

PseudoTerminal::PseudoTerminal()
    : master_(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
  if (master_ < 0 || ::grantpt(master_) != 0 || ::unlockpt(master_) != 0) fail("posix_openpt");
  std::array<char, 128> name{};
  if (::ptsname_r(master_, name.data(), name.size()) != 0) fail("ptsname_r");
  path_ = name.data();
  slave_ = ::open(path_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (slave_ < 0) fail("open");
  termios settings{};
  ::tcgetattr(slave_, &settings);
  ::cfmakeraw(&settings);
  ::tcsetattr(slave_, TCSANOW, &settings);
}

PseudoTerminal::~PseudoTerminal() { hangUp(); }

std::string PseudoTerminal::read(double timeout_s) {
  std::array<char, 4096> buffer{};
  if (master_ < 0 || !waitFor(master_, POLLIN, timeout_s)) return {};
  const auto count = ::read(master_, buffer.data(), buffer.size());
  return count > 0 ? std::string(buffer.data(), static_cast<std::size_t>(count)) : std::string();
}

bool PseudoTerminal::write(std::string_view bytes, double timeout_s) {
  const auto until = Clock::now() + std::chrono::duration<double>(timeout_s);
  while (master_ >= 0 && !bytes.empty()) {
    const double left_s = std::chrono::duration<double>(until - Clock::now()).count();
    if (left_s <= 0.0 || !waitFor(master_, POLLOUT, left_s)) return false;
    const auto count = ::write(master_, bytes.data(), bytes.size());
    if (count < 0 && errno != EAGAIN) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return bytes.empty();
}

void PseudoTerminal::purge() {
  if (slave_ >= 0) ::tcflush(slave_, TCIFLUSH);
}

void PseudoTerminal::hangUp() {
  if (slave_ >= 0) ::close(slave_);
  if (master_ >= 0) ::close(master_);
  master_ = slave_ = -1;
}

}  // namespace bslnav::test
