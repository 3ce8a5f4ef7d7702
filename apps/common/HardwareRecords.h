#pragma once

#include <bslnav/evaluation/RunMemory.h>
#include <bslnav/evaluation/RunRawlog.h>
#include <bslnav/evaluation/RunRecorder.h>
#include <bslnav/evaluation/SimulationPictures.h>
#include <bslnav/hardware/RobotDrive.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bslnav {

/** Records and draws a drive, as far as the robot itself knows it. */
class HardwareRecords {
 public:
  /** All outlive this object. */
  HardwareRecords(const SimulationSetup& setup,
                  std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> map,
                  const NavigationCycle& cycle, const Sensors& sensors, RunRecorder& recorder);

  /** @throws Error (Run) when something cannot be written */
  void add(const DriveMoment& moment);
  /** Fills in what comes from the records. Returns the pictures. */
  std::vector<std::string> finish(RunSummary& summary);

 private:
  std::vector<RunMemory::Program> programs() const;

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

}  // namespace bslnav
