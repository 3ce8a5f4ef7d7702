#pragma once

#include <bslnav/config/ConfigSection.h>

#include <string>

namespace bslnav {

/** An iRobot Create 2 or a Roomba of the 500 series and later, and where it is plugged in. The
 * defaults are those of the Create 2 Open Interface specification. */
struct CreateParameters {
  std::string port = "/dev/ttyUSB0";
  int baud = 115200;
  double wheelBase_m = 0.235;
  double wheelDiameter_m = 0.072;
  double countsPerRevolution = 508.8;  ///< of an encoder, for one turn of its wheel
  double maxWheelSpeed_mps = 0.5;      ///< what the robot can
  double commandTimeout_s = 0.3;       ///< without a command for so long, the wheels are stopped

  void describe(ConfigSection& section);
};

}  // namespace bslnav
