#pragma once

#include <bslnav/evaluation/SimulationSetup.h>
#include <bslnav/navigation/RecordedPath.h>

#include <memory>
#include <string>

namespace bslnav {

struct RawlogParameters {
  std::string file;  ///< also --rawlog
  std::string map =
      "none";  ///< "none", "log" (built from the log's own scans), or a map file; also --map
  double mapResolution_m = 0.05;  ///< of a map built from a simplemap or from the log
  mrpt::math::TPose2D initialPose;
  double goalAhead_s = 5.0;
  double gap_s = 2.0;
  int snapshots = 4;

  void describe(ConfigSection& section);
};

/** Everything that an offline evaluation is made of. */
struct RawlogSetup {
  NavigationParameters navigation;
  RawlogParameters rawlog;
  LocalizationParameters localization{PoseSource::Odometry};
  ParticleFilterParameters particleFilter;
  PictureParameters pictures;

  /** Binds every part to its section; this object must outlive the configuration. */
  void bind(Config& config);
  /** Checks of more than one key. @throws Error */
  void check() const;
};

}  // namespace bslnav
