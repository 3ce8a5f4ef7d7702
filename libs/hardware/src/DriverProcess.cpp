#include "DriverProcess.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <tuple>

extern char** environ;

namespace bslnav {
namespace {

/** Both ends of a pipe that children do not inherit unless they are told to. */
std::array<int, 2> makePipe() {
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
  return ends;
}

/** Waits for its end, asking for it first, then forcing it. */
int reap(pid_t process) {
  int status = 0;
  ::kill(process, SIGTERM);
  for (int k = 0; k < 50; ++k) {
    if (::waitpid(process, &status, WNOHANG) == process) return status;
    ::usleep(10000);
  }
  ::kill(process, SIGKILL);
  ::waitpid(process, &status, 0);
  return status;
}

/** Starts a program with no signal blocked; returns 0 or the error. */
int spawn(pid_t& process, std::string program, std::string section, int in, int out,
          const std::string& logFile) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, in, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, out, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO,
                                   logFile.empty() ? "/dev/null" : logFile.c_str(),
                                   O_WRONLY | O_CREAT | O_APPEND, 0644);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  std::array<char*, 3> arguments{program.data(), section.data(), nullptr};
  const int problem =
      ::posix_spawn(&process, program.c_str(), &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return problem;
}

}  // namespace

DriverProcess::DriverProcess(const std::string& program, const std::string& section,
                             const std::string& ini, const std::string& logFile) {
  const auto in = makePipe(), out = makePipe();
  const int problem = spawn(process_, program, section, in[0], out[1], logFile);
  ::close(in[0]);
  ::close(out[1]);
  messages_ = out[0];
  // One that ends before it has read all says by its messages and its end why.
  if (problem == 0) std::ignore = ::write(in[1], ini.data(), ini.size());
  ::close(in[1]);
  if (problem == 0) return;
  process_ = -1;
  end();
  throw std::runtime_error("cannot start " + program + ": " + std::strerror(problem));
}

std::optional<std::string> DriverProcess::read(double timeout_s) const {
  pollfd waited{messages_, POLLIN, 0};
  if (::poll(&waited, 1, static_cast<int>(1e3 * timeout_s)) <= 0) return std::string();
  std::array<char, 65536> bytes;
  const auto count = ::read(messages_, bytes.data(), bytes.size());
  if (count <= 0) return std::nullopt;
  return std::string(bytes.data(), static_cast<std::size_t>(count));
}

std::string DriverProcess::end() {
  if (messages_ >= 0) ::close(messages_);
  messages_ = -1;
  if (process_ < 0) return {};
  const int status = reap(process_);
  process_ = -1;
  if (WIFSIGNALED(status))
    return std::string("the driver crashed: ") + ::strsignal(WTERMSIG(status));
  return "the driver ended with code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace bslnav
