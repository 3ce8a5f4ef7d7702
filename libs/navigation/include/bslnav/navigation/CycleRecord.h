#pragma once

#include <bslnav/blindspot/BlindSpot.h>
#include <bslnav/costmap/DangerZone.h>
#include <bslnav/navigation/GuardRecord.h>
#include <bslnav/navigation/MotionPlanner.h>
#include <bslnav/planning/GlobalPlanner.h>

#include <string>
#include <vector>

namespace bslnav {

/** Wall-clock time of each stage of a cycle [s]; the only part of a record that differs from run to
 * run. */
struct StageTimes {
  double blindSpots_s = 0, costmap_s = 0, people_s = 0, globalPlan_s = 0, motion_s = 0, total_s = 0;
};

/** Everything one control cycle saw, considered and decided. */
struct CycleRecord {
  enum class Health : std::uint8_t { Ok, StaleSensor, NoBeams, BadPose };

  int index = 0;
  double time_s = 0.0;
  mrpt::math::TPose2D mapFromRobot;
  mrpt::math::TTwist2D twist;                   ///< measured, robot frame
  Health health = Health::Ok;                   ///< anything but Ok stops the robot
  std::string sensorProblem;                    ///< which sensor and why, in words; empty for none
  int beams = 0, droppedBeams = 0;              ///< of all scans of this cycle
  int depthFrames = 0, droppedDepthFrames = 0;  ///< of this cycle; dropped: says nothing usable
  std::vector<BlindSpot> blindSpots;       ///< of the newest scans or depth images; robot frame
                                           ///< at that time
  std::vector<DangerZone> dangerZones;     ///< map frame
  std::vector<mrpt::math::TPoint2D> path;  ///< global path, map frame; empty when there is none
  PathResult::Status pathStatus = PathResult::Status::Found;
  bool replanned = false;
  bool goalMoved = false;  ///< the path leads to the nearest reachable place instead
  Motion motion;           ///< the command is `motion.command`
  DwaResult dwa;           ///< every candidate; belongs to this cycle when motion.planned
  GuardRecord guard;       ///< the certificate of the command
  StageTimes times;
};

/** The word for a health in records and tables. */
const char* nameOf(CycleRecord::Health health);
/** Why the robot does not simply follow its path: one phrase for reports; empty when it does. */
std::string reasonOf(const CycleRecord& record);

}  // namespace bslnav
