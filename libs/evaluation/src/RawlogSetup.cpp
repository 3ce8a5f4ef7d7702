#include <bslnav/costmap/MapLoader.h>
#include <bslnav/evaluation/RawlogSetup.h>

namespace bslnav {

void RawlogParameters::describe(ConfigSection& section) {
  section.text("file", file, "the log; --rawlog overrides it");
  section.text(
      "map", map,
      "'scenario' (as [scenario] map says, none without goals there), 'none', 'log' (built "
      "from the log's own scans), or a map file; --map overrides it");
  section.choice(
      "pose", pose,
      {{"auto", LogPose::Automatic},
       {"recorded", LogPose::Recorded},
       {"localization", LogPose::Localization}},
      "where the robot was: as the log says it was localised, a control cycle a pose; as "
      "[localization] says; auto: recorded where [scenario] names goals");
  section.number("map_resolution_m", mapResolution_m, {0.01, 1.0}, "m",
                 "of a map built from a simplemap or from the log");
  section.pose("initial_pose", initialPose, "where the robot is in the map when the log begins");
  section.number("goal_ahead_s", goalAhead_s, {0.1, 600.0}, "s",
                 "without goals in [scenario], the goal is where the robot was this much later");
  section.number("gap_s", gap_s, kPositive, "s", "a step of the log's clock above this is a gap");
  section.integer("snapshots", snapshots, {0, 16}, "",
                  "cost map snapshots, spread evenly over the log");
}

void RawlogSetup::bind(Config& config) {
  config.bind("rawlog", "The log, and how it is evaluated.", rawlog);
  SimulationSetup::bind(config);
}

bool RawlogSetup::takesRecordedPoses() const {
  if (rawlog.pose == LogPose::Automatic) return !scenario.goals.empty();
  return rawlog.pose == LogPose::Recorded;
}

void RawlogSetup::check() const {
  navigation.check();
  if (rawlog.file.empty()) Config::refuse("rawlog", "file", "a log, here or with --rawlog FILE");
  const bool mapOfWorld =
      rawlog.map == "scenario" && !scenario.goals.empty() && scenario.map == "world";
  if (mapOfWorld && lasers.empty())
    Config::refuse("laser:NAME", "z_m", "a laser, at whose height [scenario] map = world is made");
  if (takesRecordedPoses()) return;
  if (localization.source == PoseSource::Truth || localization.source == PoseSource::External)
    Config::refuse("localization", "source",
                   "odometry or particle_filter: a log does not tell the truth");
  const bool noMap = rawlog.map == "none" || rawlog.map == "log" ||
                     (rawlog.map == "scenario" && scenario.goals.empty());
  if (localization.source == PoseSource::ParticleFilter && noMap)
    Config::refuse("rawlog", "map", "a map file, since [localization] source is particle_filter");
}

std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> RawlogSetup::makeMap() const {
  if (rawlog.map == "none" || rawlog.map == "log") return nullptr;
  if (rawlog.map == "scenario")
    return scenario.goals.empty() ? nullptr : SimulationSetup::makeMap();
  return loadMap(rawlog.map, {rawlog.mapResolution_m, {0.0, 0.0}});
}

}  // namespace bslnav
