#pragma once

#include <string>
#include <string_view>

namespace bslnav::test {

/** A serial line without a wire: what a driver opens at path() is read and written here. Programs
 * that are started do not inherit it. */
class PseudoTerminal {
 public:
  /** @throws std::system_error when there is none */
  PseudoTerminal();
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /** What a driver opens, such as /dev/pts/3. */
  const std::string& path() const { return path_; }

  /** What came within a time, at most; empty when nothing did. */
  std::string read(double timeout_s);
  /** Waits until all is taken, or `false`: nobody reads, or the cable is pulled. */
  bool write(std::string_view bytes, double timeout_s = 0.2);
  /** Drops what nobody has read yet. */
  void purge();

  /** Pulls the cable: the driver's reads and writes fail from now on. Nothing undoes that. */
  void hangUp();

 private:
  int master_ = -1, slave_ = -1;  // the slave is kept open, so that the line outlives its users
  std::string path_;
};

}  // namespace bslnav::test
