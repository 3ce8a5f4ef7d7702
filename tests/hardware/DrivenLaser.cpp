#include "DrivenLaser.h"

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/hwdrivers/registerAllClasses.h>

#include <stdexcept>

namespace bslnav::test {
namespace {

using Clock = std::chrono::steady_clock;
using mrpt::hwdrivers::C2DRangeFinderAbstract;
using mrpt::hwdrivers::CGenericSensor;

double since_s(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

DrivenLaser::DrivenLaser(const std::string& port, const std::string& options) {
  mrpt::hwdrivers::registerAllClasses_mrpt_hwdrivers();
  for (int k = 0; k < 3; ++k) {  // a busy machine may not answer in time
    start(port, options);
    if (driver_->getState() != CGenericSensor::ssError) break;
  }
  // Not before: it sets the laser up twice, and takes a line of the first scan that happens to end
  // in "QT" for the answer to its own QT.
  driver_->logRegisterCallback([this](std::string_view text, mrpt::system::VerbosityLevel level,
                                      std::string_view, mrpt::Clock::time_point) {
    if (level >= mrpt::system::LVL_WARN) complaints_ += std::string(text) + '\n';
  });
}

void DrivenLaser::start(const std::string& port, const std::string& options) {
  driver_.reset();  // the port is the next one's
  driver_ = std::dynamic_pointer_cast<C2DRangeFinderAbstract>(
      CGenericSensor::createSensorPtr("CHokuyoURG"));
  if (!driver_) throw std::runtime_error("this MRPT has no CHokuyoURG");
  driver_->logging_enable_console_output = false;
  const mrpt::config::CConfigFileMemory config(
      "[LASER]\n"
      "driver = CHokuyoURG\n"
      "process_rate = 90\n"
      "sensorLabel = FRONT\n"
      "pose_x = 0.21\npose_y = 0\npose_z = 0.34\n"
      "pose_yaw = 90\npose_pitch = 0\npose_roll = 0\n"
      // The driver waits so long after each answer for more to come.
      "comms_timeout_ms = 50\n"
      "COM_port_LIN = " +
      port + '\n' + options);
  driver_->loadConfig(config, "LASER");
  driver_->initialize();
}

std::vector<DrivenLaser::Scan> DrivenLaser::work() {
  driver_->doProcess();
  CGenericSensor::TListObservations arrived;
  driver_->getObservations(arrived);
  std::vector<Scan> scans;
  for (const auto& [stamp, object] : arrived)
    scans.push_back(std::dynamic_pointer_cast<Scan::element_type>(object));
  return scans;
}

std::vector<DrivenLaser::Scan> DrivenLaser::scans(std::size_t count, double timeout_s) {
  std::vector<Scan> all;
  for (const auto start = Clock::now(); all.size() < count && since_s(start) < timeout_s;)
    for (auto& scan : work()) all.push_back(std::move(scan));
  return all;
}

double DrivenLaser::waitFor(CGenericSensor::TSensorState state, double timeout_s) {
  const auto start = Clock::now();
  do work();
  while (driver_->getState() != state && since_s(start) < timeout_s);
  return since_s(start);
}

}  // namespace bslnav::test
