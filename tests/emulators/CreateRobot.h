#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace bslnav::test {

/** How an iRobot Create 2 answers to the bytes of its Open Interface; knows neither time nor lines.
 *
 * Written from iRobot's specification, apart from the driver, so that the two do not share their
 * errors. */
class CreateRobot {
 public:
  struct Wheels {
    double left_mps = 0.0, right_mps = 0.0;
  };
  enum Mode { Off, Passive, Safe, Full };

  /** Does what the bytes say; half a command waits for the rest. */
  void take(std::string_view bytes);
  /** Safe mode's own reflexes. */
  void watchFloor();
  /** A frame of the stream; empty when nobody asked for one. */
  std::string frame() const;

  bool bump = false, cliff = false, wheelDrop = false;
  double left_m = 0.0, right_m = 0.0;  ///< what the wheels have gone
  Mode mode = Off;
  Wheels wheels, lastDrive;  ///< lastDrive: the newest command, obeyed or not
  std::size_t drives = 0;    ///< commands so far

 private:
  std::size_t commandLength() const;
  void execute(std::string_view command);
  std::string packet(unsigned id) const;

  std::string in_, streamed_;
};

}  // namespace bslnav::test
