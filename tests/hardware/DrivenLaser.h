#pragma once

#include <ScipEmulator.h>
#include <mrpt/hwdrivers/C2DRangeFinderAbstract.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <chrono>
#include <string>
#include <vector>

namespace bslnav::test {

/** MRPT's Hokuyo driver at a port, worked as rawlog-grabber works it. */
class DrivenLaser {
 public:
  using Scan = mrpt::obs::CObservation2DRangeScan::Ptr;

  /** @param options more lines of the driver's section
   *  @throws std::exception when the port is not there */
  explicit DrivenLaser(const std::string& port, const std::string& options = "");
  DrivenLaser(const DrivenLaser&) = delete;
  DrivenLaser& operator=(const DrivenLaser&) = delete;

  /** Lets the driver work until it has given so many scans, or the time is up: in order of arrival.
   */
  std::vector<Scan> scans(std::size_t count, double timeout_s = 5.0);
  /** Lets it work until it is in a state; returns the time that took, at most the timeout. */
  double waitFor(mrpt::hwdrivers::CGenericSensor::TSensorState state, double timeout_s = 5.0);

  mrpt::hwdrivers::C2DRangeFinderAbstract& driver() { return *driver_; }
  bool failed() const { return driver_->getState() == mrpt::hwdrivers::CGenericSensor::ssError; }
  /** What the driver reported since it was set up, from warnings up, a message a line. */
  const std::string& complaints() const { return complaints_; }

 private:
  void start(const std::string& port, const std::string& options);
  std::vector<Scan> work();

  std::string complaints_;
  std::shared_ptr<mrpt::hwdrivers::C2DRangeFinderAbstract> driver_;
};

}  // namespace bslnav::test
