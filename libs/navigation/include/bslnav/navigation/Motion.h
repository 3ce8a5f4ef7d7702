#pragma once

#include <bslnav/planning/Guard.h>
#include <bslnav/planning/MoverForecast.h>
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace bslnav {

/** How the robot is being moved. */
enum class MotionMode : std::uint8_t {
  Idle,
  Follow,
  RotateToPath,
  StopAtGoal,
  RotateToGoal,
  BackOff,
  MakeWay,
  Arrived,
  Failed
};
/** The word for a mode in records and tables. */
const char* nameOf(MotionMode mode);

/** Where the robot is in a cycle, and where it is to go. */
struct MotionInput {
  double time_s;
  mrpt::math::TPose2D mapFromRobot;
  mrpt::math::TTwist2D twist;                     ///< measured
  mrpt::math::TTwist2D commandBase;               ///< what the next command starts from
  const std::vector<mrpt::math::TPoint2D>& path;  ///< empty: none was found
  mrpt::math::TPose2D goal;      ///< where the path leads; its heading is taken up on arrival
  double passWithin_m = 0.0;     ///< above 0: a waypoint, passed this near without stopping
  const Guard* guard = nullptr;  ///< what it refuses is no candidate
  const MoverForecast* movers = nullptr;                     ///< whom not to be in the way of
  bool looksBehind = false;                                  ///< whether it may drive back for them
  double maxSpeed_mps = std::numeric_limits<double>::max();  ///< wanted of the planner
};

/** What the robot is to do in one cycle, and what was considered. */
struct Motion {
  MotionMode mode = MotionMode::Idle;
  mrpt::math::TTwist2D command;    ///< within the limits
  bool blocked = false;            ///< no admissible candidate, or no room to turn
  bool planned = false;            ///< whether the local planner's result is of this cycle
  mrpt::math::TPoint2D localGoal;  ///< map frame
};

}  // namespace bslnav
