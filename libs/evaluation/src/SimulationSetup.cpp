#include <bslnav/config/Error.h>
#include <bslnav/costmap/MapLoader.h>
#include <bslnav/evaluation/SimulationSetup.h>
#include <bslnav/simulation/RandomStream.h>
#include <bslnav/simulation/StaticMap.h>
#include <mrpt/random/RandomGenerators.h>

namespace bslnav {
namespace {

constexpr double kSurveyHeight_m = 0.25;  // of a map of the world for a robot without laser

}  // namespace

void RobotParameters::describe(ConfigSection& section) {
  section.choice(
      "type", type,
      {{"simulated", RobotType::Simulated},
       {"create", RobotType::Create},
       {"text", RobotType::Text},
       {"plugin", RobotType::Plugin}},
      "what moves: a simulated robot; an iRobot Create 2 or Roomba ([create]); a base that "
      "speaks bslnav's text protocol ([text_base]); a base from a shared library");
}

void LocalizationParameters::describe(ConfigSection& section) {
  section.choice("source", source,
                 {{"truth", PoseSource::Truth},
                  {"odometry", PoseSource::Odometry},
                  {"particle_filter", PoseSource::ParticleFilter},
                  {"external", PoseSource::External}},
                 "where the robot's pose comes from; the truth is known only in simulation, an "
                 "external pose only from a real base that localises itself");
}

void ScenarioParameters::describe(ConfigSection& section) {
  section.text("name", name, "name in pictures and tables");
  section.pose("start", start, "where the robot starts");
  section.poses("goals", goals, "the goal, after any waypoints");
  section.integer("rounds", rounds, {1, 100000}, "",
                  "how often the goals are gone through: more than once to patrol");
  section.number("time_limit_s", timeLimit_s, kPositive, "s",
                 "the run ends as a timeout after this");
  section.text("map", map, "'world' (a survey of the simulated world), 'none', or a map file");
  section.number("trigger_variation_m", triggerVariation_m, kNonNegative, "m",
                 "over seeds, trigger lines are shifted along x by up to this");
  section.number("speed_variation", speedVariation, {0.0, 0.9}, "",
                 "over seeds, people's speeds are scaled by up to this much more or less");
}

std::vector<mrpt::math::TPose2D> ScenarioParameters::allGoals() const {
  std::vector<mrpt::math::TPose2D> all;
  for (int i = 0; i < rounds; ++i) all.insert(all.end(), goals.begin(), goals.end());
  return all;
}

void PictureParameters::describe(ConfigSection& section) {
  section.numbers("snapshots_s", snapshots_s, kNonNegative, "s", "times of the cost map snapshots");
  section.numbers("depth_stages_s", depthStages_s, kNonNegative, "s",
                  "times at which the stages from depth to danger zones are drawn");
  section.choice(
      "depth_clouds", depthClouds,
      {{"none", CloudFormat::None}, {"pcd", CloudFormat::Pcd}, {"ply", CloudFormat::Ply}},
      "format in which the clouds of those stages are saved, too");
  section.flag("record_candidates", recordCandidates,
               "whether to write candidates.csv: every candidate of every cycle");
}

void RecordingParameters::describe(ConfigSection& section) {
  section.flag("rawlog", rawlog,
               "whether to write run.rawlog: what the robot sensed and where it was localised, for "
               "MRPT's tools and for bslnav-rawlog");
  section.flag(
      "mvsim_world", mvsimWorld,
      "whether to write world.mvsim.xml: the world and the robot for MRPT's simulator MVSim");
  section.flag("scene", scene,
               "whether to write run.3Dscene: an instant of the run, for MRPT's SceneViewer3D");
  section.number("scene_s", scene_s, kNonNegative, "s",
                 "the instant of that scene; 0: the end of the run");
  section.flag("scene_picture", scenePicture,
               "whether to draw that instant as scene.png; needs OpenGL (EGL), but no display");
  section.integer("picture_width_px", pictureWidth_px, {64, 8192}, "px", "width of scene.png");
  section.integer("picture_height_px", pictureHeight_px, {64, 8192}, "px", "height of scene.png");
  section.number("memory_s", memory_s, kNonNegative, "s",
                 "so often is written to memory.csv, and drawn as memory.png, how much memory the "
                 "programs hold; 0: never");
}

void SimulationSetup::bind(Config& config) {
  config.bind("scenario", "From where to where.", scenario);
  navigation.bind(config);
  config.bind("localization", "Where the robot is.", localization);
  config.bind("particle_filter",
              "MRPT's particle filter, when [localization] source is particle_filter.",
              particleFilter);
  config.bind("robot", "The robot.", robot);
  config.bind("simulation", "What simulates it.", simulation);
  config.bind("simulated_robot", "The simulated base.", simulatedRobot);
  config.bindRepeated("laser", "A laser range finder on the robot.", lasers);
  config.bindRepeated("camera", "A depth camera on the robot, used when [depth] enabled is true.",
                      cameras);
  config.bindRepeated("wall", "A wall along a polyline.", world.walls);
  config.bindRepeated("box", "A box, or with z_min_m a table top or an overhang.", world.boxes);
  config.bindRepeated("cylinder", "A pole or a pillar.", world.cylinders);
  config.bindRepeated("pedestrian",
                      "A person who walks along a path when the robot crosses a line.",
                      world.pedestrians);
  config.bind("pictures", "What is drawn and recorded besides the standard files.", pictures);
  config.bind("recording", "What a run leaves in MRPT's formats.", recording);
}

void SimulationSetup::check() const {
  navigation.check();
  world.check();
  if (scenario.goals.empty()) Config::refuse("scenario", "goals", "at least one pose");
  if (isSimulated()) checkSimulated();
  const bool suits = isSimulated() ? localization.source != PoseSource::External
                                   : localization.source != PoseSource::Truth;
  if (!suits)
    Config::refuse("localization", "source",
                   isSimulated() ? "truth, odometry or particle_filter of a simulated robot"
                                 : "odometry, particle_filter or external of a real robot");
}

void SimulationSetup::checkSimulated() const {
  const RobotLimits& limits = navigation.limits;
  const auto canDo = [](double planned, double base, const std::string& key) {
    if (planned > base + 1e-9)
      Config::refuse("limits", key,
                     "at most what [simulated_robot] can do, " + std::to_string(base));
  };
  canDo(limits.maxSpeed_mps, simulatedRobot.maxSpeed_mps, "max_speed_mps");
  canDo(limits.acceleration_mps2, simulatedRobot.maxAcceleration_mps2, "acceleration_mps2");
  canDo(limits.deceleration_mps2, simulatedRobot.maxDeceleration_mps2, "deceleration_mps2");
  if (limits.maxLateralSpeed_mps > 0.0 && simulatedRobot.kinematics != BaseKinematics::Holonomic)
    Config::refuse("limits", "max_lateral_speed_mps",
                   "0 unless [simulated_robot] kinematics = holonomic");
  canDo(limits.maxLateralSpeed_mps, simulatedRobot.maxSpeed_mps, "max_lateral_speed_mps");
  if (lasers.empty() && !navigation.depth.enabled)
    Config::refuse("laser:NAME", "beams", "at least one laser unless [depth] enabled");
  for (const auto& [name, camera] : cameras) camera.check(name);
  if (navigation.depth.enabled && cameras.empty())
    Config::refuse("camera:NAME", "columns", "at least one camera when [depth] enabled");
}

std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> SimulationSetup::makeMap() const {
  if (scenario.map == "none") return nullptr;
  std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> map;
  const double surveyHeight_m = lasers.empty() ? kSurveyHeight_m : lasers.begin()->second.z_m;
  if (scenario.map == "world")
    map = staticMap(world, navigation.costmap.resolution_m, surveyHeight_m, 1.0);
  else
    map = loadMap(dataFile(scenario.map));
  for (const auto& goal : scenario.goals)
    if (goal.x < map->getXMin() || goal.x > map->getXMax() || goal.y < map->getYMin() ||
        goal.y > map->getYMax())
      Config::refuse("scenario", "goals",
                     "goals within the map, x " + std::to_string(map->getXMin()) + " to " +
                         std::to_string(map->getXMax()) + ", y " + std::to_string(map->getYMin()) +
                         " to " + std::to_string(map->getYMax()) + " [m]");
  return map;
}

std::unique_ptr<Localization> SimulationSetup::makeLocalization(
    const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map, std::uint64_t seed) const {
  switch (localization.source) {
    case PoseSource::Truth:
    case PoseSource::External:
      return nullptr;
    case PoseSource::Odometry:
      return std::make_unique<OdometryLocalization>(scenario.start);
    case PoseSource::ParticleFilter:
      break;
  }
  if (!map)
    Config::refuse("localization", "source", "not particle_filter when [scenario] map is none");
  return std::make_unique<ParticleFilterLocalization>(particleFilter, map, scenario.start,
                                                      static_cast<std::uint32_t>(seed));
}

SimulationCase SimulationSetup::simulationCase(std::uint64_t seed) const {
  const RobotOutline outline{navigation.footprint.polygon, navigation.footprint.radius_m};
  const bool depth = navigation.depth.enabled;
  return {world,          simulatedRobot, lasers, depth ? cameras : decltype(cameras){},
          scenario.start, outline,        seed};
}

SimulationSetup varied(SimulationSetup setup, std::uint64_t seed) {
  auto random = randomStream(seed, "variation");
  for (auto& [name, person] : setup.world.pedestrians) {
    const double shift = random.drawUniform(-1.0, 1.0) * setup.scenario.triggerVariation_m;
    for (auto& point : person.triggerLine_m) point.x += shift;
    person.speed_mps *= 1.0 + random.drawUniform(-1.0, 1.0) * setup.scenario.speedVariation;
  }
  return setup;
}

}  // namespace bslnav
