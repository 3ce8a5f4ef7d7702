#include <bslnav/config/Error.h>
#include <bslnav/navigation/DwaNavigator.h>
#include <bslnav/navigation/InPlaceRotation.h>
#include <bslnav/navigation/MrptSetup.h>
#include <mrpt/maps/CSimplePointsMap.h>

#include <cmath>

#include "PtgPaths.h"
#include "RemainingTargets.h"

namespace bslnav {

DwaNavigator::~DwaNavigator() {
  try {
    stop(false);
  } catch (...) {  // a robot that cannot be told anything any more
  }
}

void DwaNavigator::loadConfigFile(const mrpt::config::CConfigFileBase& file) {
  MrptSetup setup;
  setup.load(file);
  const std::lock_guard<std::recursive_mutex> lock(m_nav_cs);
  targets_.clear();
  cycle_ = std::make_unique<NavigationCycle>(setup.navigation, setup.makeMap());
  CWaypointsNavigator::loadConfigFile(file);
}

void DwaNavigator::onStartNewNavigation() {
  if (!cycle_) throw Error("DwaNavigator", "loadConfigFile() was not called");
  targets_.clear();
  m_last_curPoseVelUpdate_robot_time = -1e9;  // else MRPT may start without a pose
  EndsWhenFailed::onStartNewNavigation();
}

bool DwaNavigator::stop(bool isEmergencyStop) {
  if (cycle_) cycle_->noteStopped();
  return CWaypointsNavigator::stop(isEmergencyStop);
}

bool DwaNavigator::checkHasReachedTarget(const double distance_m) const {
  return CWaypointsNavigator::checkHasReachedTarget(distance_m) &&
         (m_navigationParams->target.targetIsIntermediaryWaypoint ||
          isStanding(m_curPoseVel.velLocal));
}

void DwaNavigator::step() {
  if (!cycle_) throw Error("DwaNavigator", "loadConfigFile() was not called");
  mrpt::maps::CSimplePointsMap obstacles;
  mrpt::system::TTimeStamp stamp;
  if (!m_robot.senseObstacles(obstacles, stamp))
    throw Error("robot interface", "senseObstacles() failed", Error::Kind::Run);
  const auto targets = remainingTargets(m_navigationParams.get(), m_waypoint_nav_status);
  if (targets != targets_) cycle_->setGoals(targets_ = targets);
  const CycleRecord& record =
      cycle_->step(senses_.frame(m_curPoseVel.pose, m_curPoseVel.velLocal, m_curPoseVel.rawOdometry,
                                 m_curPoseVel.timestamp, obstacles, stamp));
  {
    const std::lock_guard<std::mutex> lock(recordMutex_);
    lastRecord_ = record;
  }
  const auto command = m_robot.getStopCmd();
  setVelocity(record.motion.command, *command);
  if (!changeSpeeds(*command))
    throw Error("robot interface", "changeSpeeds() failed", Error::Kind::Run);
  if (record.motion.mode == MotionMode::Failed)
    throw Error("DwaNavigator", "gave up: " + reasonOf(record), Error::Kind::Run);
}

CycleRecord DwaNavigator::lastRecord() const {
  const std::lock_guard<std::mutex> lock(recordMutex_);
  return lastRecord_;
}

Cost DwaNavigator::costAt(const mrpt::math::TPoint2D& inRobotFrame) const {
  const auto p = m_curPoseVel.pose.composePoint(inRobotFrame);
  return cycle_->surroundings().localCosts().costAt(p.x, p.y);
}

/** Whether the straight way is free. */
bool DwaNavigator::impl_waypoint_is_reachable(const mrpt::math::TPoint2D& inRobotFrame) const {
  const std::lock_guard<std::recursive_mutex> lock(const_cast<std::recursive_mutex&>(m_nav_cs));
  if (!cycle_ || !std::isfinite(inRobotFrame.x) || !std::isfinite(inRobotFrame.y)) return false;
  const double step_m = cycle_->surroundings().localCosts().getResolution();
  const int steps = static_cast<int>(inRobotFrame.norm() / step_m) + 1;
  for (int i = 1; i <= steps; ++i)
    if (costAt(inRobotFrame * (1.0 * i / steps)) >= kInscribedCost) return false;
  return true;
}

bool DwaNavigator::checkCollisionWithLatestObstacles(
    const mrpt::math::TPose2D& inRobotFrame) const {
  if (!cycle_) return false;
  const Cost cost = costAt({inRobotFrame.x, inRobotFrame.y});
  return cost == kInscribedCost || cost == kLethalCost;
}

}  // namespace bslnav
