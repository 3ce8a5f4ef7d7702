#include "HardwareDrive.h"

#include <cstdio>
#include <iostream>

#include "CommandLine.h"
#include "HardwareRecords.h"
#include "SummaryTable.h"

namespace bslnav {
namespace {

/** A line about cycles that began too late; empty when all were on time. */
std::string latenessOf(const PaceKeeper& pace) {
  if (pace.misses() == 0) return {};
  char text[96];
  std::snprintf(text, sizeof text, "  %d of %d cycles began late, the latest by %.3f s\n",
                pace.misses(), pace.cycles(), pace.worstLateness_s());
  return text;
}

void fill(RunSummary& summary, const DriveEnd& end, double time_s) {
  using Kind = DriveEnd::Kind;
  summary.reason = end.reason;
  switch (end.kind) {
    case Kind::Arrived:
      summary.outcome = Outcome::Goal;
      summary.timeToGoal_s = time_s;
      break;
    case Kind::GaveUp:
      summary.outcome = Outcome::Stuck;
      break;
    case Kind::TimeLimit:
      summary.outcome = Outcome::Timeout;
      break;
    case Kind::Interrupted:
    case Kind::Failed:
      summary.outcome = Outcome::Error;
  }
}

}  // namespace

RunSummary driveHardware(const SimulationSetup& setup, const HardwareSetup& hardware,
                         const Config& config, const DriveOptions& options) {
  setup.check();
  hardware.check(setup.robot.type);
  const auto map = setup.makeMap();
  RunRecorder recorder(options.out, config);
  const auto localization = setup.makeLocalization(map, options.seed);
  NavigationCycle cycle(setup.navigation, map);
  cycle.setGoals(setup.scenario.allGoals());
  for (const auto& [name, section] : hardware.drivers)
    cycle.expectSensor(kindOf(section), labelOf(name, section));
  listenForInterrupts();
  const auto base = hardware.makeBase(setup.robot.type);
  Sensors sensors(hardware.drivers, hardware.sensors, sensorProgram(), recorder.directory());
  HardwareRecords records(setup, map, cycle, sensors, recorder);
  DriveParameters drive = hardware.drive;
  drive.timeLimit_s = setup.scenario.timeLimit_s;
  RobotDrive robot(cycle, *base, sensors, localization.get(), drive,
                   setup.navigation.cycle.period_s);
  std::string problem, lateness;
  double time_s = 0.0;
  const DriveEnd end = robot.run([&](const DriveMoment& moment) {
    if (moment.problem != problem && !moment.problem.empty() && !options.quiet) {
      showProgress("", options.quiet);
      std::cerr << "bslnav: " << moment.record.time_s << " s: " << moment.problem << '\n';
    }
    problem = moment.problem;
    time_s = moment.record.time_s;
    lateness = latenessOf(moment.pace);
    records.add(moment);
    if (moment.record.index % 10 == 0) showProgress(progressLine(moment.record), options.quiet);
    return !interrupted();
  });
  showProgress("", options.quiet);
  RunSummary summary;
  summary.seed = options.seed;
  summary.method = setup.navigation.method.number;
  summary.methodName = setup.navigation.method.name;
  fill(summary, end, time_s);
  const auto pictures = records.finish(summary);
  if (!options.quiet) {
    printSummary(std::cout, setup.scenario.name, summary, recorder.directory(), pictures);
    std::cout << lateness;
    for (const auto& report : sensors.reports()) {
      if (report.starts > 1)
        std::cout << "  " << report.name << ": its driver was started " << report.starts
                  << " times\n";
      if (report.refused > 0)
        std::cout << "  " << report.name << ": " << report.refused << " of "
                  << report.refused + report.frames << " measurements were refused, the last since "
                  << report.lastRefusal << '\n';
    }
  }
  return summary;
}

}  // namespace bslnav
