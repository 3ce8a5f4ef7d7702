// A program that links MRPT alone: bslnav comes by its plugin and MRPT's INI file.
#include <gtest/gtest.h>
#include <mrpt/config/CConfigFile.h>
#include <mrpt/kinematics/CVehicleSimul_DiffDriven.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/nav/reactive/CReactiveNavigationSystem.h>
#include <mrpt/nav/reactive/CRobot2NavInterfaceForSimulator.h>
#include <mrpt/system/os.h>

namespace {

class Robot : public mrpt::nav::CRobot2NavInterfaceForSimulator_DiffDriven {
 public:
  explicit Robot(mrpt::kinematics::CVehicleSimul_DiffDriven& vehicle)
      : CRobot2NavInterfaceForSimulator_DiffDriven(vehicle), vehicle_(vehicle) {
    setMinLoggingLevel(mrpt::system::LVL_ERROR);
  }
  /** A wall across the straight way. */
  bool senseObstacles(mrpt::maps::CSimplePointsMap& points,
                      mrpt::system::TTimeStamp& stamp) override {
    points.clear();
    for (double y = -0.6; y <= 0.2; y += 0.02) {
      const auto p = vehicle_.getCurrentGTPose().inverseComposePoint({2.0, y});
      points.insertPoint(static_cast<float>(p.x), static_cast<float>(p.y), 0.0f);
    }
    stamp = mrpt::Clock::now();
    return true;
  }
  void sendNavigationEndEvent() override { arrived = true; }
  bool arrived = false;

 private:
  mrpt::kinematics::CVehicleSimul_DiffDriven& vehicle_;
};

TEST(Plugin, GivesMrptsStockEngineOurMethod) {
  std::string problem;
  ASSERT_TRUE(mrpt::system::loadPluginModule(BSLNAV_PLUGIN, problem)) << problem;
  mrpt::config::CConfigFile ini(BSLNAV_SOURCE_DIR "/config/mrpt/reactive.ini");
  ini.discardSavingChanges();
  ini.write("CAbstractPTGBasedReactive", "ptg_cache_files_directory", "/dev/null");
  ini.write("CAbstractPTGBasedReactive", "evaluate_clearance", true);
  mrpt::kinematics::CVehicleSimul_DiffDriven vehicle;
  Robot robot(vehicle);
  mrpt::nav::CReactiveNavigationSystem navigator(robot, false);
  navigator.setMinLoggingLevel(mrpt::system::LVL_ERROR);
  navigator.loadConfigFile(ini);
  navigator.initialize();
  mrpt::nav::CAbstractNavigator::TNavigationParams target;
  target.target.target_coords = {4.0, 0.0, 0.0};
  navigator.navigate(&target);
  for (int i = 0; i < 600 && !robot.arrived; ++i) {
    navigator.navigationStep();
    vehicle.simulateOneTimeStep(0.1);
  }
  EXPECT_TRUE(robot.arrived) << vehicle.getCurrentGTPose().asString();
}

}  // namespace
