#include <bslnav/hardware/Sensors.h>
#include <mrpt/core/Clock.h>

#include <algorithm>
#include <filesystem>

namespace bslnav {

using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservation3DRangeScan;

namespace {

std::string valueOf(const Config::FreeSection& section, const std::string& key,
                    const std::string& otherwise) {
  const auto found = section.find(key);
  return found == section.end() ? otherwise : found->second;
}

}  // namespace

void SensorsParameters::describe(ConfigSection& section) {
  stamps.describe(section);
  section.number("silence_s", silence_s, {0.5, 600.0}, "s",
                 "a driver that delivers nothing usable for so long is started again, up to eight "
                 "times as long where it has delivered nothing since its start");
}

std::string labelOf(const std::string& name, const Config::FreeSection& section) {
  return valueOf(section, "sensorLabel", name);
}

SensorKind kindOf(const Config::FreeSection& section) {
  const std::string driver = valueOf(section, "driver", "");
  const bool camera =
      driver.find("OpenNI") != std::string::npos || driver.find("Camera") != std::string::npos ||
      driver.find("Kinect") != std::string::npos || driver == "CSwissRanger3DCamera";
  return camera ? SensorKind::Camera : SensorKind::Laser;
}

std::string sensorProgram() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "bslnav-sensor";
}

Sensors::Sensors(const std::map<std::string, Config::FreeSection>& drivers,
                 const SensorsParameters& parameters, const std::string& program,
                 const std::string& logDirectory)
    : silence_s_(parameters.silence_s) {
  for (const auto& [name, section] : drivers) {
    SensorProcess::Options options;
    options.program = program;
    if (!logDirectory.empty()) options.logFile = logDirectory + "/" + name + ".log";
    options.silence_s = parameters.silence_s;
    Report report;
    report.name = labelOf(name, section);
    report.driver = valueOf(section, "driver", "");
    report.kind = kindOf(section);
    sensors_.push_back({std::make_unique<SensorProcess>(name, section, options),
                        StampCheck(parameters.stamps), report});
  }
}

void Sensors::collect(SensorFrame& frame) {
  frame.scans.clear();
  frame.depth.clear();
  for (Sensor& sensor : sensors_) take(sensor, frame);
}

void Sensors::take(Sensor& sensor, SensorFrame& frame) {
  const auto status = sensor.process->status();
  if (!status.trouble.empty()) sensor.report.trouble = status.trouble;
  sensor.report.process = status.process;
  if (sensor.report.starts != status.starts) sensor.refusedSince_s.reset();
  sensor.report.starts = status.starts;
  CObservation2DRangeScan::ConstPtr scan;
  CObservation3DRangeScan::ConstPtr depth;
  for (const auto& observation : sensor.process->take()) {
    const auto asScan = std::dynamic_pointer_cast<const CObservation2DRangeScan>(observation);
    const auto asDepth = std::dynamic_pointer_cast<const CObservation3DRangeScan>(observation);
    if ((!asScan && !asDepth) || !isNew(sensor, *observation, asScan.get(), frame)) continue;
    sensor.report.newest = observation;
    if (asScan) scan = asScan;
    if (asDepth) depth = asDepth;
  }
  if (scan) frame.scans.push_back(scan);
  if (depth) frame.depth.push_back(depth);
  if (scan || depth) sensor.refusedSince_s.reset();
  if (!sensor.refusedSince_s || frame.time_s - *sensor.refusedSince_s <= silence_s_) return;
  sensor.process->startAgain(sensor.report.lastRefusal);
  sensor.refusedSince_s.reset();
}

/** Whether it can be believed to be new; notes that. */
bool Sensors::isNew(Sensor& sensor, const mrpt::obs::CObservation& observation,
                    const CObservation2DRangeScan* scan, const SensorFrame& frame) {
  Report& report = sensor.report;
  const double stamp_s = mrpt::Clock::toDouble(observation.timestamp) - frame.startTime_s;
  report.trouble = scan ? sensor.check.refusal(*scan, stamp_s, frame.time_s)
                        : sensor.check.refusal(stamp_s, frame.time_s);
  report.refused = sensor.check.refused();
  if (!report.trouble.empty()) {
    report.lastRefusal = report.trouble;
    if (!sensor.refusedSince_s) sensor.refusedSince_s = frame.time_s;
    return false;
  }
  const double latency_s = frame.time_s - stamp_s;
  if (report.frames++ == 0) sensor.first_s = stamp_s;
  sensor.latencies_s += latency_s;
  report.latency_s = sensor.latencies_s / report.frames;
  report.worstLatency_s = std::max(report.worstLatency_s, latency_s);
  if (stamp_s > sensor.first_s) report.rate_hz = (report.frames - 1) / (stamp_s - sensor.first_s);
  return true;
}

std::vector<Sensors::Report> Sensors::reports() const {
  std::vector<Report> reports;
  for (const Sensor& sensor : sensors_) reports.push_back(sensor.report);
  return reports;
}

}  // namespace bslnav
