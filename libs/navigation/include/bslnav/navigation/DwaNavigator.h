#pragma once

#include <bslnav/navigation/EndsWhenFailed.h>
#include <bslnav/navigation/NavigationCycle.h>
#include <bslnav/navigation/RobotSenses.h>
#include <mrpt/nav/reactive/CWaypointsNavigator.h>

#include <memory>
#include <mutex>

namespace bslnav {

/** bslnav's control cycle behind MRPT's navigator interface: targets, waypoints, events, suspend,
 * resume, cancel and error states are MRPT's, velocities those of the dynamic window.
 *
 * Its INI file needs no PTGs: [CAbstractNavigator] and [CWaypointsNavigator] of MRPT's, [bslnav]
 * (MrptSetup) and bslnav's own sections. The robot stops at MRPT's allowed distance to the target;
 * give [motion] goal_tolerance_m no larger. All public functions may be called from any thread. */
class DwaNavigator : public EndsWhenFailed<mrpt::nav::CWaypointsNavigator> {
 public:
  explicit DwaNavigator(mrpt::nav::CRobot2NavInterface& robot)
      : EndsWhenFailed(robot), senses_(robot) {}
  /** Stops the robot. */
  ~DwaNavigator() override;

  /** @throws Error */
  void loadConfigFile(const mrpt::config::CConfigFileBase& file) override;
  void initialize() override {}

  /** What the last step saw and decided. */
  CycleRecord lastRecord() const;

 protected:
  void performNavigationStep() override {
    attempt([this] { step(); });
  }
  void onStartNewNavigation() override;
  bool stop(bool isEmergencyStop) override;
  /** Arrived is who stands there: MRPT would end the navigation at speed. */
  bool checkHasReachedTarget(const double distance_m) const override;
  bool impl_waypoint_is_reachable(const mrpt::math::TPoint2D& inRobotFrame) const override;
  bool checkCollisionWithLatestObstacles(const mrpt::math::TPose2D& inRobotFrame) const override;

 private:
  void step();
  Cost costAt(const mrpt::math::TPoint2D& inRobotFrame) const;

  RobotSenses senses_;
  std::unique_ptr<NavigationCycle> cycle_;
  std::vector<mrpt::math::TPose2D> targets_;
  mutable std::mutex recordMutex_;
  CycleRecord lastRecord_;
};

}  // namespace bslnav
