#pragma once

#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <vector>

namespace bslnav {

/** What the robot knows at one instant: a control cycle's input, from simulator, hardware or log.
 *
 * Scans and depth frames carry their own stamps in MRPT's clock: age = time_s − (stamp −
 * startTime_s). A sensor without news in this cycle has no entry. */
struct SensorFrame {
  double time_s = 0;                 ///< since the start of the run or log; never decreases
  double startTime_s = 0;            ///< time_s = 0 in MRPT's clock, seconds since its epoch
  mrpt::math::TPose2D odometry;      ///< odometry frame from robot
  mrpt::math::TPose2D mapFromRobot;  ///< as localised; from a log: the odometry
  mrpt::math::TTwist2D twist;        ///< robot frame: vx, vy [m/s], omega [rad/s]
  bool afterGap = false;  ///< the clock jumped since the frame before: integrate nothing over it
  std::vector<mrpt::obs::CObservation2DRangeScan::ConstPtr> scans;
  std::vector<mrpt::obs::CObservation3DRangeScan::ConstPtr> depth;  ///< with their range image
};

}  // namespace bslnav
