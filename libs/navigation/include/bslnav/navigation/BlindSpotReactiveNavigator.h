#pragma once

#include <bslnav/navigation/PtgNavigation.h>
#include <bslnav/navigation/RobotSenses.h>
#include <bslnav/navigation/Route.h>

#include <memory>
#include <mutex>

namespace bslnav {

/** MRPT's CReactiveNavigationSystem that minds places where a person could be hidden.
 *
 * Takes the robot interface and the INI file that CReactiveNavigationSystem takes, with
 * `holonomic_method = bslnav::CHolonomicDwa` and a section [bslnav] (MrptSetup). Each step it finds
 * blind spots in what the robot senses, keeps the cost map, plans the way to the target, and lets
 * CHolonomicDwa choose the path and speed of a PTG. */
class BlindSpotReactiveNavigator : public PtgNavigation {
 public:
  using PtgNavigation::PtgNavigation;
  ~BlindSpotReactiveNavigator() override { preDestructor(); }

  /** @throws Error, or as CReactiveNavigationSystem does */
  void loadConfigFile(const mrpt::config::CConfigFileBase& file) override;

  /** What the last step saw and decided; may be called from another thread. */
  CycleRecord lastRecord() const;

 protected:
  void performNavigationStep() override;
  void onStartNewNavigation() override;
  bool stop(bool isEmergencyStop) override;
  /** Arrived is who stands there: MRPT would end the navigation at speed. */
  bool checkHasReachedTarget(const double distance_m) const override;

 private:
  bool implementSenseObstacles(mrpt::system::TTimeStamp& stamp) override;
  void updateSituation(mrpt::system::TTimeStamp obstaclesStamp);

  struct Parts;
  std::shared_ptr<Parts> parts_;
  bool braking_ = false;  // in a step, a stop is to be within the limits
  mutable std::mutex recordMutex_;
  CycleRecord lastRecord_;
};

}  // namespace bslnav
