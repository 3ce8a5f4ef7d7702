#pragma once

#include <bslnav/config/ConfigSection.h>
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <map>
#include <string>
#include <vector>

namespace bslnav {

/** A wall along a polyline: each segment is a block with the line in its middle. */
struct WallParameters {
  std::vector<mrpt::math::TPoint2D> points_m;
  double thickness_m = 0.1;
  double zMin_m = 0.0, zMax_m = 2.0;
  bool mapped = true;  ///< whether the static map shows it

  void describe(ConfigSection& section);
};

/** An upright box; raised above the floor it is a table top or an overhang. */
struct BoxParameters {
  mrpt::math::TPose2D pose;  ///< centre and heading in the map
  double length_m = 0.5;     ///< along the heading
  double width_m = 0.5;      ///< across it
  double zMin_m = 0.0, zMax_m = 1.0;
  bool mapped = true;

  void describe(ConfigSection& section);
};

/** An upright cylinder: a pole, a pillar, a bin. */
struct CylinderParameters {
  double x_m = 0.0, y_m = 0.0;  ///< centre in the map
  double radius_m = 0.05;
  double zMin_m = 0.0, zMax_m = 2.0;
  bool mapped = true;

  void describe(ConfigSection& section);
};

/** A person who walks a path once, at constant speed but for one pause, and stays at its end. */
struct PedestrianParameters {
  std::vector<mrpt::math::TPoint2D> path_m;  ///< at least two points
  double speed_mps = 4.0 / 3.6;              ///< paper: 4.0 km/h
  double radius_m = 0.25, height_m = 1.7;
  std::vector<mrpt::math::TPoint2D> triggerLine_m;  ///< two points, or empty: triggered at time 0
  double startDelay_s = 0.0;                        ///< from the trigger to the first step
  double pauseAfter_m = 0.0, pause_s = 0.0;         ///< where on the path to stand, and how long
  double yieldsWithin_m = 0.0;     ///< waits while going on would lead nearer to the robot's centre
  double walksRoundAfter_s = 0.0;  ///< of waiting, where there is room; 0: waits on

  void describe(ConfigSection& section);
};

/** Everything around the robot, by name; the map frame's plane z = 0 is the floor. */
struct WorldParameters {
  std::map<std::string, WallParameters> walls;
  std::map<std::string, BoxParameters> boxes;
  std::map<std::string, CylinderParameters> cylinders;
  std::map<std::string, PedestrianParameters> pedestrians;

  /** Refuses too few or coinciding points, upper faces not above lower ones, sizes not above 0.
   *  @throws Error naming section and key */
  void check() const;
};

}  // namespace bslnav
