#pragma once

#include <sys/types.h>

#include <string>

namespace bslnav {

/** Writes bytes to a file when this process ends, however it ends: it is killed, it crashes, it
 * returns from main.
 *
 * A child process waits for that; signals to this process, or to all of its terminal, do not end
 * it. Meant for bases that drive on with their last command for ever. */
class Keeper {
 public:
  /** @param path a file or device; relative to the working directory
   *  @param lastWords what to write
   *  @throws Error (Run) when there is no such file, or no child to be had */
  Keeper(const std::string& path, const std::string& lastWords);
  /** When it returns, the bytes are written, or the file did not take them within a second. */
  ~Keeper();
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;

 private:
  int lifeline_ = -1;  // the end of a socket pair that the system closes with this process
  pid_t child_ = -1;
};

}  // namespace bslnav
