#include <bslnav/hardware/SensorDriver.h>
#include <bslnav/hardware/SensorMessages.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/core/exceptions.h>
#include <mrpt/hwdrivers/CGenericSensor.h>
#include <mrpt/hwdrivers/registerAllClasses.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <thread>

namespace bslnav {
namespace {

using mrpt::hwdrivers::CGenericSensor;

std::atomic<bool> ends{false};

bool tell(int out, const std::string& trouble) {
  return write(out, {SensorMessage::Kind::Trouble, trouble});
}

/** What went wrong, without where in MRPT. */
std::string wordsOf(const std::exception& problem) {
  std::string all = mrpt::exception_to_str(problem);
  const std::string lead = "Message:";
  const auto found = all.find(lead);
  if (found == std::string::npos) return all;
  const auto from = all.find_first_not_of(' ', found + lead.size());
  return all.substr(from, all.find('\n', from) - from);
}

CGenericSensor::Ptr makeSensor(const mrpt::config::CConfigFileBase& config,
                               const std::string& section) {
  mrpt::hwdrivers::registerAllClasses_mrpt_hwdrivers();
  const std::string driver = config.read_string(section, "driver", "");
  auto sensor = CGenericSensor::createSensorPtr(driver);
  if (!sensor)
    throw std::runtime_error("no driver '" + driver +
                             "'; expected the class of one of MRPT's, such as CHokuyoURG");
  sensor->setSensorLabel(section);  // unless the section says otherwise
  sensor->loadConfig(config, section);
  sensor->initialize();
  // Some would go on as if they worked, and never deliver.
  if (sensor->getState() == CGenericSensor::ssError)
    throw std::runtime_error("the device does not answer when it is set up");
  return sensor;
}

/** Returns whether somebody still reads. */
bool deliver(CGenericSensor& sensor, int out) {
  for (const auto& [stamp, object] : sensor.getObservations()) {
    const auto* observation = dynamic_cast<const mrpt::obs::CObservation*>(object.get());
    if (observation && !write(out, messageOf(*observation))) return false;
  }
  return true;
}

}  // namespace

int runSensorDriver(const std::string& ini, const std::string& section, int out) {
  std::signal(SIGTERM, [](int) { ends = true; });
  std::signal(SIGINT, SIG_IGN);   // Ctrl-C is for whoever started this
  std::signal(SIGPIPE, SIG_IGN);  // and tells by a failed write that it is gone
  try {
    const mrpt::config::CConfigFileMemory config(ini);
    const auto sensor = makeSensor(config, section);
    // As in rawlog-grabber, a driver says how often it wants to be asked.
    const double rate_hz = sensor->getProcessRate() > 0.0 ? sensor->getProcessRate() : 200.0;
    const auto pause = std::chrono::duration<double>(1.0 / rate_hz);
    bool inTrouble = false;
    while (!ends) {
      sensor->doProcess();
      if (!deliver(*sensor, out)) break;
      const bool trouble = sensor->getState() == CGenericSensor::ssError;
      if (trouble && !inTrouble && !tell(out, "the device does not answer as it should")) break;
      inTrouble = trouble;
      std::this_thread::sleep_for(pause);
    }
    return 0;
  } catch (const std::exception& problem) {
    tell(out, wordsOf(problem));
    return 1;
  }
}

}  // namespace bslnav
