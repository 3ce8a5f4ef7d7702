#include <bslnav/config/Error.h>
#include <bslnav/hardware/Keeper.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>

namespace bslnav {
namespace {

// Between fork() and _exit() there are async-signal-safe calls alone: the parent may have had
// threads, and their locks, such as that of the heap, stay locked for ever in the child.

/** What the child inherits would live on in it: ports stay taken, and whoever waits for the end of
 * the parent's output waits for the child. */
void closeAllBut(int one, int other, int limit) {
  const auto lower = static_cast<unsigned>(std::min(one, other));
  const auto upper = static_cast<unsigned>(std::max(one, other));
  bool closed = lower == 0 || ::close_range(0, lower - 1, 0) == 0;
  closed = (lower + 1 == upper || ::close_range(lower + 1, upper - 1, 0) == 0) && closed;
  closed = ::close_range(upper + 1, ~0U, 0) == 0 && closed;
  if (closed) return;
  for (int file = 0; file < limit; ++file)  // a kernel before 5.9
    if (file != one && file != other) ::close(file);
}

void writeWithinASecond(int file, std::string_view bytes) {
  for (int tries = 0; tries < 100 && !bytes.empty(); ++tries) {
    const auto count = ::write(file, bytes.data(), bytes.size());
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
    if (count >= 0 || errno == EINTR) continue;
    if (errno != EAGAIN) return;
    pollfd waited{file, POLLOUT, 0};
    ::poll(&waited, 1, 10);
  }
}

[[noreturn]] void keep(int file, int lifeline, int limit, std::string_view lastWords) {
  ::setsid();  // out of the group that a terminal's Ctrl-C, or a kill of all of a job, goes to
  ::prctl(PR_SET_NAME, "bslnav-keeper");
  closeAllBut(file, lifeline, limit);
  char byte = 0;
  // Until here, what kills the parent's whole group kills this process, too: the parent waits.
  writeWithinASecond(lifeline, {&byte, 1});
  while (::read(lifeline, &byte, 1) < 0 && errno == EINTR) {
  }
  writeWithinASecond(file, lastWords);
  ::_exit(0);
}

/** Blocks every signal as long as it lives; who is forked meanwhile never gets one but SIGKILL. */
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsBlocked() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_{};
};

/** Returns when the child is in place. */
pid_t forkKeeper(int file, const std::array<int, 2>& lifeline, std::string_view lastWords) {
  const int limit = static_cast<int>(std::clamp(::sysconf(_SC_OPEN_MAX), 1024L, 1L << 20));
  const SignalsBlocked blocked;
  const pid_t child = ::fork();
  if (child == 0) keep(file, lifeline[1], limit, lastWords);
  char ready = 0;
  ::close(lifeline[1]);
  return child > 0 && ::read(lifeline[0], &ready, 1) == 1 ? child : -1;
}

}  // namespace

Keeper::Keeper(const std::string& path, const std::string& lastWords) {
  const auto refuse = [&](const std::string& what) {
    throw Error(path, what + ": " + std::strerror(errno), Error::Kind::Run);
  };
  // Whoever this process starts later must not hold the lifeline: hence the CLOEXEC.
  const int file = ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) refuse("cannot be opened");
  std::array<int, 2> lifeline{-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, lifeline.data()) == 0)
    child_ = forkKeeper(file, lifeline, lastWords);
  ::close(file);
  lifeline_ = lifeline[0];
  if (child_ > 0) return;
  if (lifeline_ >= 0) ::close(lifeline_);
  refuse("no process to write to it at the end");
}

Keeper::~Keeper() {
  ::close(lifeline_);
  while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace bslnav
