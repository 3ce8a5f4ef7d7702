// A Create 2 with a SCIP 2.0 laser in the world of a scenario, in real time, until Ctrl-C: prints
// where to find the two, so that bslnav and other programs can be tried on their drivers without a
// robot.
#include <bslnav/config/Error.h>
#include <bslnav/evaluation/SimulationSetup.h>
#include <bslnav/hardware/CreateParameters.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <thread>

#include "EmulatedRobot.h"

namespace {

std::atomic<bool> interrupted{false};

void emulate(const char* scenario) {
  using namespace bslnav;
  SimulationSetup setup;
  Config config;
  setup.bind(config);
  config.load({scenario});
  test::EmulatedRobot robot(setup.simulationCase(1), test::ScipModel{},
                            CreateParameters().wheelBase_m);
  std::printf("--set create.port=%s --set front_laser.COM_port_LIN=%s\n",
              robot.base().path().c_str(), robot.laser().path().c_str());
  std::fflush(stdout);
  while (!interrupted) std::this_thread::sleep_for(std::chrono::milliseconds(100));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("Emulates a Create 2 with a laser.\nUsage: emulated-robot SCENARIO.ini\n", stderr);
    return 2;
  }
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { interrupted = true; });
  try {
    emulate(argv[1]);
    return 0;
  } catch (const bslnav::Error& problem) {
    std::fprintf(stderr, "emulated-robot: %s\n", problem.what());
    return problem.exitCode();
  }
}
