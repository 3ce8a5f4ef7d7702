#include "HardwareCheck.h"

#include <bslnav/config/Error.h>
#include <bslnav/evaluation/CycleSnapshots.h>
#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "CommandLine.h"

namespace bslnav {
namespace {

constexpr double kLeast_s = 3.0, kMost_s = 12.0;  // that are looked at the devices
constexpr int kEnoughFrames = 10;
constexpr int kEnoughStarts = 3;  // of a driver that delivers nothing, to give it up

/** What is known of a base without moving it. */
struct BaseCheck {
  std::string problem;
  int states = 0;
  double ages_s = 0.0, oldest_s = 0.0;  ///< of its states when they are asked for

  void look(Base* base) {
    if (!base) return;
    try {
      const BaseState state = base->state();
      const double age_s = mrpt::Clock::nowDouble() - state.stamp_s;
      problem = state.halt;
      ++states;
      ages_s += age_s;
      oldest_s = std::max(oldest_s, age_s);
    } catch (const Error& error) {
      problem = error.what();
    }
  }
};

std::string calibrationOf(const mrpt::obs::CObservation::Ptr& newest) {
  char text[96] = "-";
  if (const auto scan = std::dynamic_pointer_cast<mrpt::obs::CObservation2DRangeScan>(newest))
    std::snprintf(text, sizeof text, "%zu beams over %.0f deg, to %.1f m", scan->getScanSize(),
                  static_cast<double>(scan->aperture) * 180.0 / M_PI,
                  static_cast<double>(scan->maxRange));
  if (const auto depth = std::dynamic_pointer_cast<mrpt::obs::CObservation3DRangeScan>(newest))
    std::snprintf(text, sizeof text, "%ux%u, focal length %.1f px", depth->cameraParams.ncols,
                  depth->cameraParams.nrows, depth->cameraParams.fx());
  return text;
}

void printRow(const std::string& device, const std::string& driver, const std::string& rate_hz,
              double latency_s, double worst_s, int frames, int refused, const std::string& what) {
  std::printf("  %-14s %-16s %7s %10.0f %8.0f %7d %8d  %s\n", device.c_str(), driver.c_str(),
              rate_hz.c_str(), 1e3 * latency_s, 1e3 * worst_s, frames, refused, what.c_str());
}

std::string oneDecimal(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

/** Returns whether all of them deliver. */
bool printTable(const std::vector<Sensors::Report>& reports, const BaseCheck& base,
                const std::string& baseDriver) {
  std::printf("  %-14s %-16s %7s %10s %8s %7s %8s  %s\n", "device", "driver", "rate Hz",
              "latency ms", "worst ms", "frames", "refused", "calibration, or trouble");
  bool all = base.states > 0;
  printRow("base", baseDriver, "-", base.ages_s / std::max(1, base.states), base.oldest_s,
           base.states, 0, base.problem.empty() ? "-" : base.problem);
  for (const auto& r : reports) {
    const bool delivers = r.frames > 1 && r.trouble.empty();
    all = all && delivers;
    printRow(r.name, r.driver, oneDecimal(r.rate_hz), r.latency_s, r.worstLatency_s, r.frames,
             r.refused, delivers ? calibrationOf(r.newest) : r.trouble);
  }
  std::fflush(stdout);
  return all;
}

void drawCosts(const NavigationCycle& cycle, const CycleRecord& record, const Footprint& footprint,
               const std::string& path) {
  const CostGrid& costs = cycle.surroundings().localCosts();
  const People* people = cycle.surroundings().people();
  MapPicture picture("Check: the cost map of all sensors", "around the robot, which stands",
                     {costs.getXMin(), costs.getYMin(), costs.getXMax(), costs.getYMax()});
  drawSnapshot(picture, {record, costs, {}, people ? people->frontier() : Frontier{}}, footprint);
  picture.save(path);
}

/** The base, or null and why. */
std::unique_ptr<Base> connect(const HardwareSetup& hardware, RobotType type, std::string& problem) {
  try {
    return hardware.makeBase(type);
  } catch (const Error& error) {
    if (error.kind() == Error::Kind::Configuration) throw;
    problem = error.what();
    return nullptr;
  }
}

}  // namespace

int checkHardware(const SimulationSetup& setup, const HardwareSetup& hardware,
                  const DriveOptions& options) {
  setup.check();
  hardware.check(setup.robot.type);
  std::filesystem::create_directories(options.out);
  NavigationCycle cycle(setup.navigation, setup.makeMap());
  for (const auto& [name, section] : hardware.drivers)
    cycle.expectSensor(kindOf(section), labelOf(name, section));
  listenForInterrupts();
  BaseCheck baseCheck;
  const auto base = connect(hardware, setup.robot.type, baseCheck.problem);
  Sensors sensors(hardware.drivers, hardware.sensors, sensorProgram(), options.out);
  OdometryLocalization localization(setup.scenario.start);
  DriveClock clock;
  PaceKeeper pace(setup.navigation.cycle.period_s);
  const CycleRecord* record = nullptr;
  for (SensorFrame frame; clock.time_s() < kMost_s && !interrupted();) {
    pace.wait();
    clock.followJumps();
    frame.time_s = clock.time_s();
    frame.startTime_s = clock.startTime_s();
    sensors.collect(frame);
    baseCheck.look(base.get());
    frame.mapFromRobot = localization.update(frame);
    record = &cycle.step(frame);
    const auto reports = sensors.reports();
    const bool enough = std::all_of(reports.begin(), reports.end(), [](const auto& r) {
      return r.frames >= kEnoughFrames || (r.frames == 0 && r.starts >= kEnoughStarts);
    });
    if (enough && clock.time_s() > kLeast_s) break;
  }
  const bool all = printTable(sensors.reports(), baseCheck, nameOf(setup.robot.type));
  if (record && record->health == CycleRecord::Health::Ok) {
    drawCosts(cycle, *record, setup.navigation.footprint, options.out + "/check.png");
    std::printf("  %s/check.png\n", options.out.c_str());
  }
  return all ? 0 : 1;
}

}  // namespace bslnav
