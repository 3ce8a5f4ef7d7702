#include "HardwareRecords.h"

#include <bslnav/planning/RobotLimits.h>
#include <unistd.h>

#include <utility>

namespace bslnav {

HardwareRecords::HardwareRecords(const SimulationSetup& setup,
                                 std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> map,
                                 const NavigationCycle& cycle, const Sensors& sensors,
                                 RunRecorder& recorder)
    : setup_(setup),
      cycle_(cycle),
      sensors_(sensors),
      recorder_(recorder),
      pictures_(setup, std::move(map)) {
  if (setup.recording.rawlog) rawlog_.emplace(recorder.path("run.rawlog"));
  if (setup.recording.memory_s > 0.0)
    memory_.emplace(recorder.directory(), setup.recording.memory_s);
}

void HardwareRecords::add(const DriveMoment& moment) {
  const CycleRecord& record = moment.record;
  if (rawlog_) rawlog_->write(moment.frame);
  recorder_.write(record, record.mapFromRobot);
  if (record.health == CycleRecord::Health::BadPose) return;  // nothing to add up or to draw
  const double passed_s = record.time_s - known_.time_s;
  known_.time_s = record.time_s;
  known_.pose = record.mapFromRobot;
  known_.twist = record.twist;
  const mrpt::math::TPoint2D position{known_.pose.x, known_.pose.y};
  metrics_.add(record, position, speedOf(known_.twist), passed_s);
  pictures_.observe({record, known_, cycle_, moment.frame});
  if (memory_) memory_->observe(record.time_s, position, [this] { return programs(); });
}

std::vector<std::string> HardwareRecords::finish(RunSummary& summary) {
  summary.duration_s = known_.time_s;
  metrics_.finish(summary);
  recorder_.finish(summary);
  auto pictures = pictures_.save(summary, recorder_.directory());
  if (memory_) pictures.push_back(memory_->save(setup_.scenario.name + ": memory"));
  return pictures;
}

std::vector<RunMemory::Program> HardwareRecords::programs() const {
  std::vector<RunMemory::Program> programs{{"bslnav", ::getpid()}};
  for (const auto& report : sensors_.reports())
    programs.push_back({report.driver + " " + report.name, report.process});
  return programs;
}

}  // namespace bslnav
