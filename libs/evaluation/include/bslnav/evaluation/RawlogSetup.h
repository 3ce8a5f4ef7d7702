#pragma once

#include <bslnav/evaluation/SimulationSetup.h>
#include <bslnav/navigation/RecordedPath.h>

#include <memory>
#include <string>

namespace bslnav {

/** Where the poses of a log's robot come from. */
enum class LogPose : std::uint8_t {
  Automatic,  ///< recorded where [scenario] names goals, else as [localization] says
  Recorded,
  Localization
};

struct RawlogParameters {
  std::string file;  ///< also --rawlog
  /** "scenario" (that of the recorded run), "none", "log" (built from the log's own scans), or a
   * map file; also --map */
  std::string map = "scenario";
  LogPose pose = LogPose::Automatic;
  double mapResolution_m = 0.05;  ///< of a map built from a simplemap or from the log
  mrpt::math::TPose2D initialPose;
  double goalAhead_s = 5.0;
  double gap_s = 2.0;
  int snapshots = 4;

  void describe(ConfigSection& section);
};

/** Everything that an offline evaluation is made of: the log, and a run's configuration.
 *
 * What the configuration says of a world, a scenario and sensors is how the log came about: with
 * goals in [scenario], the log is a run to these goals. */
struct RawlogSetup : SimulationSetup {
  RawlogSetup() { localization.source = PoseSource::Odometry; }

  RawlogParameters rawlog;

  /** Whether the robot was where the log says it was localised. */
  bool takesRecordedPoses() const;
  /** Whether the log is taken for a run with this configuration, of which every cycle is repeated:
   * the recorded poses, the goals of the scenario, the sensors of the robot. */
  bool repeatsRun() const { return takesRecordedPoses() && !scenario.goals.empty(); }
  /** The map that is known without reading the log; null for none. @throws Error */
  std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> makeMap() const;

  /** Binds every part to its section; this object must outlive the configuration. */
  void bind(Config& config);
  /** Checks of more than one key. @throws Error */
  void check() const;
};

}  // namespace bslnav
