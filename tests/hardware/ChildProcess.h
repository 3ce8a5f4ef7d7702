#pragma once

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>

namespace bslnav::test {

/** A process of its own, and the leader of a group, that is there to be killed.
 *
 * Make it while this process has one thread: what it does may start more. */
class ChildProcess {
 public:
  /** @param action should not return */
  explicit ChildProcess(const std::function<void()>& action) : id_(::fork()) {
    if (id_ != 0) return;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // does not outlive a test that fails
    ::setpgid(0, 0);
    std::signal(SIGINT, SIG_DFL);  // else ignored where the tests run in the background
    try {
      action();
    } catch (...) {
    }
    ::_exit(1);
  }
  ~ChildProcess() { end(SIGKILL); }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  bool runs() const { return id_ > 0; }

  /** Sends a signal to all of its group, and waits for the process. */
  void end(int signal) {
    if (id_ <= 0) return;
    if (::kill(-id_, signal) != 0) ::kill(id_, signal);
    ::waitpid(id_, nullptr, 0);
    id_ = -1;
  }

 private:
  pid_t id_;
};

}  // namespace bslnav::test
