#include <bslnav/navigation/NavigationParameters.h>

namespace bslnav {

void MethodParameters::describe(ConfigSection& section) {
  section.integer("number", number, {0, 99}, "", "number of the method in reports");
  section.text("name", name, "name of the method in reports");
}

void BlindSpotParameters::describe(ConfigSection& section) {
  section.choice("source", source,
                 {{"none", BlindSpotSource::None},
                  {"scan_jumps", BlindSpotSource::ScanJumps},
                  {"depth_clusters", BlindSpotSource::DepthClusters}},
                 "where blind spots come from: none (Method 1), jumps between laser beams (Method "
                 "2), clusters of depth points (Methods 3 and 4)");
}

void DepthParameters::describe(ConfigSection& section) {
  section.flag("enabled", enabled, "whether depth cameras are used: Methods 3 and 4");
  section.number("blind_within_m", blindWithin_m, kNonNegative, "m",
                 "a camera without any depth is not taken for broken where a laser meets something "
                 "this near before it, all across its view; from the camera along its axis");
  obstacles.describe(section);
}

void CycleParameters::describe(ConfigSection& section) {
  section.number("period_s", period_s, {0.01, 1.0}, "s", "control period");
  section.number("replan_period_s", replanPeriod_s, {0.01, 60.0}, "s",
                 "a new global path at least this often");
  section.number("waypoint_tolerance_m", waypointTolerance_m, kPositive, "m",
                 "this near, a waypoint is passed");
  section.number("sensor_max_range_m", sensorMaxRange_m, kNonNegative, "m",
                 "ranges from here on mean that nothing was seen; 0 takes each scan's own maximum");
  section.number("sensor_max_age_s", sensorMaxAge_s, kPositive, "s",
                 "an older scan is stale: the robot stops");
}

void NavigationParameters::bind(Config& config) {
  config.bind("method", "The method, for reports; what it does is in the sections below.", method);
  config.bind("footprint", "The robot's outline.", footprint);
  config.bind("limits", "What the robot's base can do.", limits);
  config.bind("costmap", "The layered cost map.", costmap);
  config.bind("depth", "Depth cameras, and obstacles from them.", depth);
  config.bind("blind_spots", "Where could a person be hidden?", blindSpots);
  config.bind("scan_jumps", "Blind spots from jumps between neighbouring laser beams (paper IV).",
              scanJumps);
  config.bind("depth_clusters", "Blind spots from clusters of depth points (paper V-B).",
              depthClusters);
  config.bind("danger_zone", "The cost around a blind spot (paper IV-B, table I).", dangerZone);
  config.bind("guard", "Only velocities from which the robot can stop for whoever steps out.",
              guard);
  config.bind(
      "movers",
      "Whom not to be in the way of, with a guard; who walks counts by [dwa] weight_movers.",
      movers);
  config.bind("person_visibility", "How far depth cameras see people; for the guard.",
              personVisibility);
  config.bind("hidden_people", "Where somebody may be whom no sensor sees; for the guard.",
              hiddenPeople);
  config.bind("seen_people", "Who of what the map does not explain may walk off; for the guard.",
              seenPeople);
  config.bind("global_planner", "A* on static, obstacle and inflation costs.", globalPlanner);
  config.bind("navigator", "The engine that chooses velocities.", navigator);
  config.bind("dwa", "Dynamic window approach with the paper's cost function (eq. 10, table I).",
              dwa);
  config.bind("motion", "Along the path and at the goal.", motion);
  config.bind("recovery", "What to do when the planner cannot go on.", recovery);
  config.bind("cycle", "The control cycle.", cycle);
}

void NavigationParameters::check() const {
  footprint.check();
  costmap.check();
  if (cycle.replanPeriod_s < cycle.period_s)
    Config::refuse("cycle", "replan_period_s", "at least [cycle] period_s");
  if (dwa.horizon_s < cycle.period_s)
    Config::refuse("dwa", "horizon_s", "at least [cycle] period_s");
  if (limits.maxLateralSpeed_mps > 0.0 && dwa.lateralSamples < 2)
    Config::refuse("dwa", "lateral_samples",
                   "at least 2 with [limits] max_lateral_speed_mps above 0");
  if (blindSpots.source == BlindSpotSource::DepthClusters && !depth.enabled)
    Config::refuse("depth", "enabled", "true with [blind_spots] source = depth_clusters");
  if (depth.obstacles.zMax_m <= depth.obstacles.zMin_m)
    Config::refuse("depth", "obstacle_z_max_m", "a height above obstacle_z_min_m");
  if (personVisibility.floor_m >= personVisibility.height_m)
    Config::refuse("person_visibility", "floor_m", "a height below height_m");
  depthClusters.check();
}

}  // namespace bslnav
