// MRPT's simulated robot and MRPT's example configuration drive through case S1: a navigator's class name and three lines
// of configuration make them mind the places where a person could be hidden.
#include <bslnav/evaluation/SimulationSetup.h>
#include <bslnav/navigation/BlindSpotReactiveNavigator.h>
#include <mrpt/config/CConfigFile.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/nav/reactive/CRobot2NavInterfaceForSimulator.h>

#include <cstdio>

struct Robot : mrpt::nav::CRobot2NavInterfaceForSimulator_DiffDriven {
  Robot(mrpt::kinematics::CVehicleSimul_DiffDriven& vehicle, const mrpt::maps::COccupancyGridMap2D& world)
      : CRobot2NavInterfaceForSimulator_DiffDriven(vehicle), vehicle(vehicle), world(world) {}

  bool senseObstacles(mrpt::maps::CSimplePointsMap& obstacles, mrpt::system::TTimeStamp& stamp) override {
    mrpt::obs::CObservation2DRangeScan scan;
    scan.aperture = static_cast<float>(M_PI);
    scan.maxRange = 8.0f;
    world.laserScanSimulator(scan, mrpt::poses::CPose2D(vehicle.getCurrentGTPose()), 0.5f, 361);
    obstacles.loadFromRangeScan(scan);
    stamp = mrpt::Clock::now();
    return true;
  }
  void sendNavigationEndEvent() override { arrived = true; }

  mrpt::kinematics::CVehicleSimul_DiffDriven& vehicle;
  const mrpt::maps::COccupancyGridMap2D& world;
  bool arrived = false;
};

int main(int argc, char** argv) {
  bslnav::SimulationSetup s1;
  bslnav::Config config;
  s1.bind(config);
  config.load({bslnav::dataDirectory() + "/config/scenarios/s1.ini"});
  const auto world = s1.makeMap();
  mrpt::kinematics::CVehicleSimul_DiffDriven vehicle;
  Robot robot(vehicle, *world);

  mrpt::config::CConfigFile ini(argc > 1 ? argv[1] : "/usr/share/mrpt/config_files/navigation-ptgs/reactive2d_config.ini");
  ini.discardSavingChanges();
  ini.write("CAbstractPTGBasedReactive", "holonomic_method", "bslnav::CHolonomicDwa");  // the three lines
  ini.write("bslnav", "method", 2);
  ini.write("limits", "max_speed_mps", 0.55);
  bslnav::BlindSpotReactiveNavigator navigator(robot, false);
  navigator.setMinLoggingLevel(mrpt::system::LVL_ERROR);
  navigator.loadConfigFile(ini);
  navigator.initialize();

  mrpt::nav::CAbstractNavigator::TNavigationParams target;
  target.target.target_coords = s1.scenario.goals.back();
  navigator.navigate(&target);
  for (int i = 0; i < 900 && !robot.arrived; ++i, vehicle.simulateOneTimeStep(0.1)) navigator.navigationStep();
  const auto& pose = vehicle.getCurrentGTPose();
  std::printf("%s after %.1f s at %.2f, %.2f\n", robot.arrived ? "arrived" : "not there", vehicle.getTime(), pose.x, pose.y);
  return robot.arrived ? 0 : 1;
}
