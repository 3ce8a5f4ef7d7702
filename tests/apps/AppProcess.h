#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace bslnav::test {

using Arguments = std::vector<std::string>;

/** What a program did. */
struct AppResult {
  int exitCode = -1;  ///< minus the signal's number when one ended it
  std::string out, err;
};

/** A program as a child process, its output going to files. */
class AppProcess {
 public:
  /** Starts it. @param program name of a program of this build, or a path @param directory of its
   * output files */
  AppProcess(const std::string& program, const Arguments& arguments, std::string directory);
  /** Kills it if it is still running. */
  ~AppProcess();
  AppProcess(const AppProcess&) = delete;
  AppProcess& operator=(const AppProcess&) = delete;

  void send(int signal) const;
  /** From now on its files must not grow beyond this: as on a disk that is full. */
  void limitFiles(unsigned long bytes) const;
  bool isRunning();
  /** Waits for its end. */
  AppResult wait();

 private:
  std::string directory_;
  pid_t pid_ = -1;
  int status_ = 0;
};

}  // namespace bslnav::test
