#include "AppProcess.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <stdexcept>
#include <utility>

#include "AppTest.h"

namespace bslnav::test {

AppProcess::AppProcess(const std::string& program, const Arguments& arguments,
                       std::string directory)
    : directory_(std::move(directory)) {
  Arguments words = arguments;
  const bool ofThisBuild = program.front() != '/';
  words.insert(words.begin(), (ofThisBuild ? BSLNAV_PROGRAMS "/" : "") + program);
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  constexpr int kNewFile = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, (directory_ + "/stdout").c_str(), kNewFile, 0644);
  posix_spawn_file_actions_addopen(&files, 2, (directory_ + "/stderr").c_str(), kNewFile, 0644);
  const int problem = posix_spawn(&pid_, argv[0], &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (problem != 0) throw std::runtime_error("cannot start " + words[0]);
}

AppProcess::~AppProcess() {
  if (pid_ < 0) return;
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

void AppProcess::limitFiles(unsigned long bytes) const {
  const rlimit limit{bytes, bytes};
  ::prlimit(pid_, RLIMIT_FSIZE, &limit, nullptr);
}

void AppProcess::send(int signal) const {
  if (pid_ > 0) kill(pid_, signal);
}

bool AppProcess::isRunning() {
  if (pid_ > 0 && waitpid(pid_, &status_, WNOHANG) == pid_) pid_ = -1;
  return pid_ > 0;
}

AppResult AppProcess::wait() {
  if (pid_ > 0) waitpid(pid_, &status_, 0);
  pid_ = -1;
  const int code = WIFEXITED(status_) ? WEXITSTATUS(status_) : -WTERMSIG(status_);
  return {code, readFile(directory_ + "/stdout"), readFile(directory_ + "/stderr")};
}

}  // namespace bslnav::test
