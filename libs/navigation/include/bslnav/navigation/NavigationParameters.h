#pragma once

#include <bslnav/blindspot/DangerZones.h>
#include <bslnav/blindspot/DepthClusters.h>
#include <bslnav/blindspot/HiddenPeople.h>
#include <bslnav/blindspot/PersonVisibility.h>
#include <bslnav/blindspot/ScanJumpDetector.h>
#include <bslnav/blindspot/SeenPeopleParameters.h>
#include <bslnav/config/Config.h>
#include <bslnav/costmap/DepthScan.h>
#include <bslnav/costmap/LayeredCostmap.h>
#include <bslnav/navigation/MotionPlanner.h>
#include <bslnav/navigation/NavigatorParameters.h>
#include <bslnav/planning/DwaParameters.h>
#include <bslnav/planning/GlobalPlanner.h>
#include <bslnav/planning/Guard.h>

#include <string>

namespace bslnav {

/** Which of the paper's methods this is, for reports; what a method does is in the other sections.
 */
struct MethodParameters {
  int number = 1;
  std::string name = "ROS default";

  void describe(ConfigSection& section);
};

/** Where blind spots come from. */
enum class BlindSpotSource : std::uint8_t { None, ScanJumps, DepthClusters };

struct BlindSpotParameters {
  BlindSpotSource source = BlindSpotSource::None;

  void describe(ConfigSection& section);
};

/** Whether depth cameras count, and which of their points are obstacles. */
struct DepthParameters {
  bool enabled = false;
  double blindWithin_m = 0.5;  ///< nearer things a camera may not see
  DepthScanParameters obstacles;

  void describe(ConfigSection& section);
};

struct CycleParameters {
  double period_s = 0.1;        ///< control period
  double replanPeriod_s = 1.0;  ///< a new global path at least this often
  double waypointTolerance_m = 0.4;
  double sensorMaxRange_m = 0.0;  ///< ranges from here on are no return; 0: as the scan says
  double sensorMaxAge_s = 0.5;    ///< an older scan is stale: the robot stops

  void describe(ConfigSection& section);
};

/** Everything the control cycle can be told, each part described by its owner. */
struct NavigationParameters {
  MethodParameters method;
  Footprint footprint;
  RobotLimits limits;
  CostmapParameters costmap;
  DepthParameters depth;
  BlindSpotParameters blindSpots;
  ScanJumpParameters scanJumps;
  DepthClusterParameters depthClusters;
  DangerZoneParameters dangerZone;
  GuardParameters guard;
  MoverParameters movers;
  PersonVisibilityParameters personVisibility;
  HiddenPeopleParameters hiddenPeople;
  SeenPeopleParameters seenPeople;
  GlobalPlannerParameters globalPlanner;
  NavigatorParameters navigator;
  DwaParameters dwa;
  MotionParameters motion;
  RecoveryParameters recovery;
  CycleParameters cycle;

  /** Binds every part to its section; this object must outlive the configuration. */
  void bind(Config& config);
  /** Checks of more than one key. @throws Error */
  void check() const;
};

}  // namespace bslnav
