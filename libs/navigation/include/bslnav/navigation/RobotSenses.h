#pragma once

#include <bslnav/navigation/SensorFrame.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/nav/reactive/CRobot2NavInterface.h>

namespace bslnav {

/** What a robot interface may also be: a source of scans and depth images. Without it, blind spots
 * are found in the scan that MRPT's obstacle points make up, and depth is not available. */
class SensorSource {
 public:
  virtual ~SensorSource() = default;

  /** Appends what is new since the last call, with stamps of the clock that getCurrentPoseAndSpeeds
   * uses. */
  virtual void sense(SensorFrame& frame) = 0;
};

/** The scan that a set of obstacle points around the robot makes up: in each of `beams` directions
 * the nearest point; a direction without a point says nothing. No point at all is an open place. */
mrpt::obs::CObservation2DRangeScan::Ptr scanOf(const mrpt::maps::CSimplePointsMap& points,
                                               int beams, double maxRange_m);

/** Makes a control cycle's input of what MRPT's robot interface tells. */
class RobotSenses {
 public:
  explicit RobotSenses(mrpt::nav::CRobot2NavInterface& robot) : robot_(robot) {}

  /** @param pose,twist,odometry,stamp as MRPT's navigator has asked for them; twist in the robot
   * frame
   *  @param obstacles in the robot frame, and when they were seen: old ones make the cycle stop */
  SensorFrame frame(const mrpt::math::TPose2D& pose, const mrpt::math::TTwist2D& twist,
                    const mrpt::math::TPose2D& odometry, mrpt::system::TTimeStamp stamp,
                    const mrpt::maps::CSimplePointsMap& obstacles,
                    mrpt::system::TTimeStamp obstaclesStamp);

 private:
  mrpt::nav::CRobot2NavInterface& robot_;
};

}  // namespace bslnav
