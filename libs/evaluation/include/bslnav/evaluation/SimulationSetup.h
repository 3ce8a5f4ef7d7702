#pragma once

#include <bslnav/evaluation/PointCloudFile.h>
#include <bslnav/evaluation/SimulationEngines.h>
#include <bslnav/navigation/LocalizationParticleFilter.h>
#include <bslnav/navigation/NavigationParameters.h>
#include <bslnav/simulation/SimulationEngine.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace bslnav {

/** What moves. */
enum class RobotType : std::uint8_t { Simulated, Create, Text, Plugin };

struct RobotParameters {
  RobotType type = RobotType::Simulated;

  void describe(ConfigSection& section);
};

/** Where the robot's pose comes from. */
enum class PoseSource : std::uint8_t { Truth, Odometry, ParticleFilter, External };

struct LocalizationParameters {
  PoseSource source = PoseSource::Truth;

  void describe(ConfigSection& section);
};

/** One case: from where to where, in which map, and what varies from seed to seed. */
struct ScenarioParameters {
  std::string name = "unnamed";
  mrpt::math::TPose2D start;
  std::vector<mrpt::math::TPose2D> goals;  ///< the last one is the goal, those before are waypoints
  int rounds = 1;                          ///< how often they are gone through
  double timeLimit_s = 90.0;
  std::string map = "world";  ///< "world": a survey of it; "none"; or a file
  double triggerVariation_m = 0.0;
  double speedVariation = 0.0;

  void describe(ConfigSection& section);
  /** The goals of all rounds. */
  std::vector<mrpt::math::TPose2D> allGoals() const;
};

struct PictureParameters {
  std::vector<double> snapshots_s, depthStages_s;
  CloudFormat depthClouds = CloudFormat::None;
  bool recordCandidates = false;

  void describe(ConfigSection& section);
};

/** What a run leaves in MRPT's own formats. */
struct RecordingParameters {
  bool rawlog = false, mvsimWorld = false, scene = false, scenePicture = false;
  double scene_s = 0.0;   ///< instant of the scene; 0: the end of the run
  double memory_s = 0.0;  ///< from one look at the memory to the next; 0: none
  int pictureWidth_px = 1600, pictureHeight_px = 900;

  void describe(ConfigSection& section);
};

/** Everything that a simulated run is made of. */
struct SimulationSetup {
  NavigationParameters navigation;
  ScenarioParameters scenario;
  LocalizationParameters localization;
  ParticleFilterParameters particleFilter;
  RobotParameters robot;
  SimulationParameters simulation;
  SimulatedRobotParameters simulatedRobot;
  std::map<std::string, LaserParameters> lasers;
  std::map<std::string, DepthCameraParameters>
      cameras;  ///< used when `navigation.depth` is enabled
  WorldParameters world;
  PictureParameters pictures;
  RecordingParameters recording;

  /** Binds every part to its section; this object must outlive the configuration. */
  void bind(Config& config);
  /** Checks of more than one key. @throws Error */
  void check() const;
  bool isSimulated() const { return robot.type == RobotType::Simulated; }
  /** The static map that the robot navigates by; null for none. @throws Error */
  std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> makeMap() const;
  /** What tells where the robot is, from the scenario's start on; null when nobody has to: the
   * truth is known, or the base localises itself. @throws Error when the map is missing for it */
  std::unique_ptr<Localization> makeLocalization(
      const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map, std::uint64_t seed) const;
  /** What an engine has to simulate; cameras only when `navigation.depth` is enabled. */
  SimulationCase simulationCase(std::uint64_t seed) const;

 private:
  void checkSimulated() const;
};

/** The setup of one seed: trigger lines shifted along x and speeds scaled, uniformly within the
 * scenario's variation. */
SimulationSetup varied(SimulationSetup setup, std::uint64_t seed);

}  // namespace bslnav
