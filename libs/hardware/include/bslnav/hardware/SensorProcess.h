#pragma once

#include <bslnav/config/Config.h>
#include <bslnav/hardware/SensorMessages.h>

#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace bslnav {

class DriverProcess;

/** A sensor driver of MRPT's in a process of its own, and the thread that listens to it.
 *
 * Whatever happens to the driver (it crashes, aborts without its device, hangs), it is started
 * again, and nobody else notices but by the sensor's silence. */
class SensorProcess {
 public:
  struct Options {
    std::string program;     ///< bslnav-sensor
    std::string logFile;     ///< gets what the driver prints; empty: nobody does
    double again_s = 1.0;    ///< from an end to the next start
    double silence_s = 5.0;  ///< a driver that delivers nothing for so long is started again;
                             ///< after each start in vain twice as long, up to eight times
  };
  struct Status {
    int starts = 0, observations = 0;
    int process = -1;     ///< the driver's; -1: it does not run now
    std::string trouble;  ///< the last there was, in words; empty since it delivers
  };

  /** @param section the driver's, in rawlog-grabber's format; its name is the sensor's label unless
   * it has `sensorLabel` */
  SensorProcess(std::string name, const Config::FreeSection& section, Options options);
  /** Ends the driver, the hard way if it does not end within half a second. */
  ~SensorProcess();
  SensorProcess(const SensorProcess&) = delete;
  SensorProcess& operator=(const SensorProcess&) = delete;

  const std::string& name() const { return name_; }
  /** What it delivered since the last call. */
  std::vector<mrpt::obs::CObservation::Ptr> take();
  Status status() const;
  /** The driver is ended and started again: what it delivers is of no use. */
  void startAgain(const std::string& why);

 private:
  void supervise();
  std::string listen(const DriverProcess& driver, double silence_s);
  void accept(const SensorMessage& message);
  bool waitOrEnd(double time_s);

  std::string name_, ini_;
  Options options_;
  mutable std::mutex mutex_;
  std::condition_variable endingChanged_;
  bool ending_ = false;
  std::optional<std::string> toEnd_;  // why the driver is to be started again
  Status status_;
  std::vector<mrpt::obs::CObservation::Ptr> observations_;
  std::thread thread_;
};

}  // namespace bslnav
