// Runs one sensor driver of MRPT's in a process of its own, so that a driver that crashes or hangs
// takes nobody with it. Started by bslnav: the driver's section comes by the standard input,
// messages go to the standard output.
#include <bslnav/hardware/SensorDriver.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <string>

int main(int argc, char** argv) {
  if (argc != 2 || std::string(argv[1]) == "--help") {
    std::fputs("Runs a sensor driver for bslnav.\nUsage: bslnav-sensor SECTION < CONFIG.ini\n",
               stderr);
    return 2;
  }
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  const int out = ::dup(STDOUT_FILENO);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);  // what drivers print is no message
  const std::string ini{std::istreambuf_iterator<char>(std::cin), {}};
  return bslnav::runSensorDriver(ini, argv[1], out);
}
