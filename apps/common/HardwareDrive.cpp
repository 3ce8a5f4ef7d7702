#include "HardwareDrive.h"

#include <bslnav/evaluation/RunMemory.h>
#include <bslnav/evaluation/RunRawlog.h>
#include <bslnav/evaluation/RunRecorder.h>
#include <bslnav/evaluation/SimulationPictures.h>
#include <bslnav/planning/RobotLimits.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <optional>

#include "CommandLine.h"
#include "SummaryTable.h"

namespace bslnav {
namespace {

/** Records and draws a drive, as far as the robot itself knows it. */
class Records {
 public:
  Records(const SimulationSetup& setup,
          const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map,
          const NavigationCycle& cycle, const Sensors& sensors, RunRecorder& recorder)
      : setup_(setup),
        cycle_(cycle),
        sensors_(sensors),
        recorder_(recorder),
        pictures_(setup, map) {
    if (setup.recording.rawlog) rawlog_.emplace(recorder.path("run.rawlog"));
    if (setup.recording.memory_s > 0.0)
      memory_.emplace(recorder.directory(), setup.recording.memory_s);
  }

  void add(const DriveMoment& moment) {
    const CycleRecord& record = moment.record;
    if (rawlog_) rawlog_->write(moment.frame);
    recorder_.write(record, record.mapFromRobot);
    if (record.health == CycleRecord::Health::BadPose) return;  // nothing to add up or to draw
    const double passed_s = record.time_s - known_.time_s;
    known_.time_s = record.time_s;
    known_.pose = record.mapFromRobot;
    known_.twist = record.twist;
    metrics_.add(record, {known_.pose.x, known_.pose.y}, speedOf(known_.twist), passed_s);
    pictures_.observe({record, known_, cycle_, moment.frame});
    if (memory_)
      memory_->observe(record.time_s, {known_.pose.x, known_.pose.y},
                       [this] { return programs(); });
  }

  /** Returns the pictures. */
  std::vector<std::string> finish(RunSummary& summary) {
    summary.duration_s = known_.time_s;
    metrics_.finish(summary);
    recorder_.finish(summary);
    auto pictures = pictures_.save(summary, recorder_.directory());
    if (memory_) pictures.push_back(memory_->save(setup_.scenario.name + ": memory"));
    return pictures;
  }

 private:
  std::vector<RunMemory::Program> programs() const {
    std::vector<RunMemory::Program> programs{{"bslnav", ::getpid()}};
    for (const auto& report : sensors_.reports())
      programs.push_back({report.driver + " " + report.name, report.process});
    return programs;
  }

  const SimulationSetup& setup_;
  const NavigationCycle& cycle_;
  const Sensors& sensors_;
  RunRecorder& recorder_;
  SimulationPictures pictures_;
  std::optional<RunRawlog> rawlog_;
  std::optional<RunMemory> memory_;
  Metrics metrics_;
  SimulationState known_;  // nobody knows the truth here
};

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
  Records records(setup, map, cycle, sensors, recorder);
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
    for (const auto& report : sensors.reports())
      if (report.refused > 0)
        std::cout << "  " << report.name << ": " << report.refused << " of "
                  << report.refused + report.frames << " measurements were refused, the last since "
                  << report.lastRefusal << '\n';
  }
  return summary;
}

}  // namespace bslnav
