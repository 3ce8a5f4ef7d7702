#include <bslnav/hardware/SensorProcess.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstring>
#include <sstream>
#include <utility>

extern char** environ;

namespace bslnav {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostKept = 200;  // observations that nobody takes

std::string iniOf(const std::string& name, const Config::FreeSection& section) {
  std::ostringstream text;
  text << "[" << name << "]\n";
  for (const auto& [key, value] : section) text << key << " = " << value << "\n";
  return text.str();
}

/** Both ends of a pipe that children do not inherit unless they are told to. */
std::array<int, 2> makePipe() {
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
  return ends;
}

/** How a process ended, in words. */
std::string endOf(int status) {
  if (WIFSIGNALED(status))
    return std::string("the driver crashed: ") + ::strsignal(WTERMSIG(status));
  return "the driver ended with code " + std::to_string(WEXITSTATUS(status));
}

/** Waits for its end, asking for it first, then forcing it. */
int reap(int process) {
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

}  // namespace

SensorProcess::SensorProcess(std::string name, Config::FreeSection section, Options options)
    : name_(std::move(name)),
      ini_(iniOf(name_, section)),
      options_(std::move(options)),
      thread_([this] { supervise(); }) {}

SensorProcess::~SensorProcess() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  endingChanged_.notify_all();
  thread_.join();
}

std::vector<mrpt::obs::CObservation::Ptr> SensorProcess::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(observations_, {});
}

SensorProcess::Status SensorProcess::status() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return status_;
}

bool SensorProcess::isEnding() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ending_;
}

bool SensorProcess::waitOrEnd(double time_s) {
  std::unique_lock<std::mutex> lock(mutex_);
  return endingChanged_.wait_for(lock, std::chrono::duration<double>(time_s),
                                 [this] { return ending_; });
}

void SensorProcess::supervise() {
  // A driver that ends before it has read its section is no reason to end.
  sigset_t pipe;
  sigemptyset(&pipe);
  sigaddset(&pipe, SIGPIPE);
  ::pthread_sigmask(SIG_BLOCK, &pipe, nullptr);
  do {
    std::string trouble;
    try {
      const Child child = start();
      trouble = listen(child);
      ::close(child.messages);
      const int status = reap(child.process);
      if (trouble.empty()) trouble = endOf(status);
    } catch (const std::exception& problem) {
      trouble = problem.what();
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    status_.trouble = trouble;
    status_.process = -1;
  } while (!waitOrEnd(options_.again_s));
}

SensorProcess::Child SensorProcess::start() const {
  const auto in = makePipe(), out = makePipe();
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, in[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, out[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(
      &files, STDERR_FILENO, options_.logFile.empty() ? "/dev/null" : options_.logFile.c_str(),
      O_WRONLY | O_CREAT | O_APPEND, 0644);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  std::string program = options_.program, section = name_;
  std::array<char*, 3> arguments{program.data(), section.data(), nullptr};
  Child child;
  const int problem = ::posix_spawn(&child.process, program.c_str(), &files, &attributes,
                                    arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  ::close(in[0]);
  ::close(out[1]);
  // It is short and fits into the pipe.
  const bool written =
      problem == 0 && ::write(in[1], ini_.data(), ini_.size()) == static_cast<ssize_t>(ini_.size());
  ::close(in[1]);
  child.messages = out[0];
  if (written) return child;
  ::close(out[0]);
  if (problem == 0) reap(child.process);
  throw std::runtime_error("cannot start " + program + ": " + std::strerror(problem));
}

/** Until the driver's process ends, is silent for too long, or is to end; returns what was the
 * trouble, empty when the process says more by how it ends. */
std::string SensorProcess::listen(const Child& child) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++status_.starts;
    status_.process = child.process;
  }
  SensorMessageReader reader;
  std::string trouble;
  auto heard = Clock::now();
  for (std::array<char, 65536> bytes; !isEnding();) {
    pollfd waited{child.messages, POLLIN, 0};
    if (::poll(&waited, 1, 50) > 0) {
      const auto count = ::read(child.messages, bytes.data(), bytes.size());
      if (count <= 0) return trouble;
      reader.add(bytes.data(), static_cast<std::size_t>(count));
    }
    while (const auto message = reader.next()) {
      accept(*message);
      if (message->kind == SensorMessage::Kind::Trouble)
        trouble = message->bytes;
      else
        heard = Clock::now();
    }
    if (std::chrono::duration<double>(Clock::now() - heard).count() > options_.silence_s)
      return trouble.empty() ? "the driver delivers nothing" : trouble;
  }
  return trouble;
}

void SensorProcess::accept(const SensorMessage& message) {
  const bool isTrouble = message.kind == SensorMessage::Kind::Trouble;
  auto observation = isTrouble ? nullptr : observationOf(message);
  const std::lock_guard<std::mutex> lock(mutex_);
  status_.trouble = isTrouble ? message.bytes : std::string();
  if (isTrouble) return;
  ++status_.observations;
  if (observations_.size() >= kMostKept) observations_.erase(observations_.begin());
  observations_.push_back(std::move(observation));
}

}  // namespace bslnav
