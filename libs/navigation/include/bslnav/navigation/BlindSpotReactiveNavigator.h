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

 private:
  bool implementSenseObstacles(mrpt::system::TTimeStamp& stamp) override;
  void updateSituation();

  struct Parts;
  std::shared_ptr<Parts> parts_;
  mutable std::mutex recordMutex_;
  CycleRecord lastRecord_;
};

}  // namespace bslnav
