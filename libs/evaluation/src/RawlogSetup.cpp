#include <bslnav/evaluation/RawlogSetup.h>

namespace bslnav {

void RawlogParameters::describe(ConfigSection& section) {
  section.text("file", file, "the log; --rawlog overrides it");
  section.text("map", map,
               "'none', 'log' (built from the log's own scans), or a map file; --map overrides it");
  section.number("map_resolution_m", mapResolution_m, {0.01, 1.0}, "m",
                 "of a map built from a simplemap or from the log");
  section.pose("initial_pose", initialPose, "where the robot is in the map when the log begins");
  section.number("goal_ahead_s", goalAhead_s, {0.1, 600.0}, "s",
                 "the goal is where the robot was this much later");
  section.number("gap_s", gap_s, kPositive, "s", "a step of the log's clock above this is a gap");
  section.integer("snapshots", snapshots, {0, 16}, "",
                  "cost map snapshots, spread evenly over the log");
}

void RawlogSetup::bind(Config& config) {
  config.bind("rawlog", "The log, and how it is evaluated.", rawlog);
  navigation.bind(config);
  config.bind("localization", "Where the robot was.", localization);
  config.bind("particle_filter",
              "MRPT's particle filter, when [localization] source is particle_filter.",
              particleFilter);
  config.bind("pictures", "What is drawn and recorded besides the standard files.", pictures);
}

void RawlogSetup::check() const {
  navigation.check();
  if (rawlog.file.empty()) Config::refuse("rawlog", "file", "a log, here or with --rawlog FILE");
  if (localization.source == PoseSource::Truth)
    Config::refuse("localization", "source",
                   "odometry or particle_filter: a log does not tell the truth");
  if (localization.source == PoseSource::ParticleFilter &&
      (rawlog.map == "none" || rawlog.map == "log"))
    Config::refuse("rawlog", "map", "a map file, since [localization] source is particle_filter");
}

}  // namespace bslnav
