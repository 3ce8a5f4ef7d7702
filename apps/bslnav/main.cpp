// Drives a robot to its goal, in the simulator or a real one: what the configuration describes is
// what moves.
#include <bslnav/config/Error.h>
#ifdef BSLNAV_WITH_MVSIM
#include <bslnav/mvsim/MvsimSimulator.h>
#endif

#include <iostream>
#include <memory>

#include "CommandLine.h"
#include "HardwareCheck.h"
#include "HardwareDrive.h"
#include "RecordedDrive.h"
#include "SummaryTable.h"

namespace {

/** The engines that this build has. */
bslnav::SimulationEngines availableEngines() {
  bslnav::SimulationEngines engines;
#ifdef BSLNAV_WITH_MVSIM
  engines.add(bslnav::EngineKind::Mvsim, [](const bslnav::SimulationCase& simulated) {
    return std::make_unique<bslnav::MvsimSimulator>(simulated);
  });
#endif
  return engines;
}

int drive(const bslnav::CommonOptions& options, bool check) {
  using namespace bslnav;
  SimulationSetup setup;
  HardwareSetup hardware;
  Config config;
  setup.bind(config);
  hardware.bind(config);
  options.load(config);
  if (options.printConfig) {
    config.print(std::cout);
    return 0;
  }
  if (options.configs.empty())
    throw Error("CONFIG", "no configuration; expected bslnav CONFIG.ini, see --help");
  const DriveOptions drive{options.seed, options.out, options.quiet};
  if (check && setup.isSimulated())
    throw Error("--check",
                "there is nothing to check of a simulated robot; expected another [robot] type");
  if (check) return checkHardware(setup, hardware, drive);
  return exitCodeOf(setup.isSimulated() ? driveRecorded(setup, config, drive, availableEngines())
                                        : driveHardware(setup, hardware, config, drive));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Drives a robot past blind spots to its goal.", "bslnav");
  app.footer("Example:\n  bslnav config/scenarios/s1.ini --method 2 --out out/s1-method2");
  bslnav::CommonOptions options;
  options.addTo(app, "out");
  bool check = false;
  app.add_flag("--check", check,
               "open every device of a real robot, print what each delivers, and move nothing");
  return bslnav::runApp(app, argc, argv, [&] { return drive(options, check); });
}
