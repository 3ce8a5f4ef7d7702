#include <bslnav/config/Error.h>
#include <bslnav/navigation/BlindSpotReactiveNavigator.h>
#include <bslnav/navigation/InPlaceRotation.h>
#include <bslnav/navigation/MrptSetup.h>
#include <bslnav/planning/PathDistance.h>

#include <optional>

#include "PtgPaths.h"
#include "RemainingTargets.h"

namespace bslnav {

/** Everything that a configuration makes. */
struct BlindSpotReactiveNavigator::Parts {
  Parts(const MrptSetup& setup, mrpt::nav::CRobot2NavInterface& robot)
      : parameters(setup.navigation),
        senses(robot),
        surroundings(parameters, setup.makeMap()),
        route(parameters) {}

  NavigationParameters parameters;
  RobotSenses senses;
  Surroundings surroundings;
  Route route;
  std::vector<mrpt::math::TPose2D> targets;
  CycleRecord record;
  mrpt::math::TTwist2D lastCommand;
  std::optional<DwaSituation> situation;
};

void BlindSpotReactiveNavigator::loadConfigFile(const mrpt::config::CConfigFileBase& file) {
  MrptSetup setup;
  setup.load(file);
  parts_ = std::make_shared<Parts>(setup, m_robot);
  const NavigationParameters& p = parts_->parameters;
  use(p.dwa, p.limits, p.cycle.period_s,
      std::make_shared<CandidateEvaluator>(p.dwa, p.limits, parts_->surroundings.footprintCover()));
  PtgNavigation::loadConfigFile(file);
}

void BlindSpotReactiveNavigator::onStartNewNavigation() {
  if (!parts_) throw Error("BlindSpotReactiveNavigator", "loadConfigFile() was not called");
  parts_->targets.clear();
  PtgNavigation::onStartNewNavigation();
}

void BlindSpotReactiveNavigator::performNavigationStep() {
  if (!parts_) {
    doEmergencyStop("BlindSpotReactiveNavigator: loadConfigFile() was not called");
    return;
  }
  setSituation(nullptr);
  Parts& parts = *parts_;
  braking_ = true;
  PtgNavigation::performNavigationStep();
  braking_ = false;
  if (result().best >= 0) parts.lastCommand = lastVelocity();
  parts.record.dwa = result();
  parts.record.motion.command = parts.lastCommand;
  parts.record.motion.planned = true;
  const std::lock_guard<std::mutex> lock(recordMutex_);
  lastRecord_ = parts.record;
}

/** MRPT calls this once a step, before it decides: the place to look around. */
bool BlindSpotReactiveNavigator::implementSenseObstacles(mrpt::system::TTimeStamp& stamp) {
  if (!m_robot.senseObstacles(m_WS_Obstacles, stamp)) return false;
  m_WS_Obstacles_original = m_WS_Obstacles;
  updateSituation(stamp);
  return true;
}

/** Where MRPT finds no way it wants an emergency stop: the robot brakes within its limits instead.
 */
bool BlindSpotReactiveNavigator::stop(bool isEmergencyStop) {
  if (!parts_ || !braking_ || failing()) {
    if (parts_) parts_->lastCommand = {};
    return PtgNavigation::stop(isEmergencyStop);
  }
  const NavigationParameters& p = parts_->parameters;
  parts_->lastCommand = brake(commandBase(m_curPoseVel.velLocal, parts_->lastCommand, p.limits),
                              p.limits, p.cycle.period_s);
  const auto command = m_robot.getStopCmd();
  setVelocity(parts_->lastCommand, *command);
  return changeSpeeds(*command);
}

bool BlindSpotReactiveNavigator::checkHasReachedTarget(const double distance_m) const {
  return PtgNavigation::checkHasReachedTarget(distance_m) &&
         (m_navigationParams->target.targetIsIntermediaryWaypoint ||
          isStanding(m_curPoseVel.velLocal));
}

void BlindSpotReactiveNavigator::updateSituation(mrpt::system::TTimeStamp obstaclesStamp) {
  Parts& parts = *parts_;
  CycleRecord& record = parts.record;
  const SensorFrame frame =
      parts.senses.frame(m_curPoseVel.pose, m_curPoseVel.velLocal, m_curPoseVel.rawOdometry,
                         m_curPoseVel.timestamp, m_WS_Obstacles, obstaclesStamp);
  record.time_s = frame.time_s;
  parts.surroundings.update(frame, record);
  if (record.health != CycleRecord::Health::Ok)
    throw Error("BlindSpotReactiveNavigator", reasonOf(record), Error::Kind::Run);
  const auto targets = remainingTargets(m_navigationParams.get(), m_waypoint_nav_status);
  if (targets != parts.targets) parts.route.setGoals(parts.targets = targets);
  parts.route.update(parts.surroundings, false, record);
  if (record.path.empty())
    throw Error("BlindSpotReactiveNavigator", describe(record.pathStatus), Error::Kind::Run);
  const mrpt::math::TPoint2D robot{frame.mapFromRobot.x, frame.mapFromRobot.y};
  const auto goal = pointAhead(record.path, robot, parts.parameters.motion.lookahead_m);
  const bool atEnd = (goal - record.path.back()).norm() < 1e-9;
  const bool stops = parts.route.passWithin_m() == 0.0;
  const double tolerance =
      stops ? parts.parameters.motion.goalTolerance_m : parts.route.passWithin_m();
  record.motion.localGoal = goal;
  parts.situation.emplace(DwaSituation{
      {frame.mapFromRobot, commandBase(frame.twist, parts.lastCommand, parts.parameters.limits),
       record.path, goal, atEnd ? tolerance : 0.0, atEnd && stops},
      &parts.surroundings.localCosts()});
  setSituation(&*parts.situation);
}

CycleRecord BlindSpotReactiveNavigator::lastRecord() const {
  const std::lock_guard<std::mutex> lock(recordMutex_);
  return lastRecord_;
}

}  // namespace bslnav
