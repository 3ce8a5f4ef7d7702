#pragma once

#include <bslnav/hardware/SensorProcess.h>
#include <bslnav/hardware/StampCheck.h>
#include <bslnav/navigation/SensorFrame.h>
#include <bslnav/navigation/SensorWatch.h>

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bslnav {

struct SensorsParameters {
  StampCheckParameters stamps;
  double silence_s = 5.0;  ///< a driver that delivers nothing usable for so long is started again

  void describe(ConfigSection& section);
};

/** All sensors of a robot: MRPT's drivers, each in a process of its own. */
class Sensors {
 public:
  /** What one sensor did so far. */
  struct Report {
    std::string name, driver;
    SensorKind kind = SensorKind::Laser;
    int frames = 0, refused = 0;
    int starts = 0;    ///< of its driver
    int process = -1;  ///< the driver's; -1: it does not run now
    double rate_hz = 0.0, latency_s = 0.0,
           worstLatency_s = 0.0;          ///< from its stamp until collected
    std::string trouble;                  ///< the newest, in words; empty: none
    std::string lastRefusal;              ///< why the last measurement was refused that was
    mrpt::obs::CObservation::Ptr newest;  ///< null: nothing came yet
  };

  /** Starts the drivers.
   *  @param drivers sections in rawlog-grabber's format, by name
   *  @param program bslnav-sensor; @param logDirectory gets what drivers print; empty: nobody does
   */
  Sensors(const std::map<std::string, Config::FreeSection>& drivers,
          const SensorsParameters& parameters, const std::string& program,
          const std::string& logDirectory);

  /** Puts the newest of each sensor that came since the last call, and can be believed to be new,
   * into a frame, whose time is set. */
  void collect(SensorFrame& frame);

  std::vector<Report> reports() const;

 private:
  struct Sensor {
    std::unique_ptr<SensorProcess> process;
    StampCheck check;
    Report report;
    double first_s = 0.0, latencies_s = 0.0;
    std::optional<double> refusedSince_s{};  // while nothing but what is refused comes
  };

  void take(Sensor& sensor, SensorFrame& frame);
  static bool isNew(Sensor& sensor, const mrpt::obs::CObservation& observation,
                    const mrpt::obs::CObservation2DRangeScan* scan, const SensorFrame& frame);

  double silence_s_;
  std::deque<Sensor> sensors_;
};

/** The label that a driver's observations carry, and whether it is a laser or a camera. */
std::string labelOf(const std::string& name, const Config::FreeSection& section);
SensorKind kindOf(const Config::FreeSection& section);
/** bslnav-sensor, which is installed beside the program that runs. */
std::string sensorProgram();

}  // namespace bslnav
