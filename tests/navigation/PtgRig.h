#pragma once

#include <bslnav/config/Config.h>
#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/kinematics/CVehicleSimul_DiffDriven.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/nav/reactive/CAbstractNavigator.h>
#include <mrpt/nav/reactive/CRobot2NavInterfaceForSimulator.h>
#include <mrpt/nav/registerAllClasses.h>
#include <mrpt/nav/tpspace/CParameterizedTrajectoryGenerator.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace bslnav::test {

/** config/mrpt/reactive.ini, to be changed by a test. */
inline mrpt::config::CConfigFileMemory reactiveIni() {
  std::ifstream file(dataDirectory() + "/config/mrpt/reactive.ini");
  std::stringstream text;
  text << file.rdbuf();
  mrpt::config::CConfigFileMemory ini;
  ini.setContent(text.str());
  ini.write("CAbstractPTGBasedReactive", "ptg_cache_files_directory", std::string("/dev/null"));
  return ini;
}

/** The PTG of the first entry of that file. */
inline mrpt::nav::CParameterizedTrajectoryGenerator::Ptr makePtg() {
  mrpt::nav::registerAllClasses_mrpt_nav();
  auto ptg = mrpt::nav::CParameterizedTrajectoryGenerator::CreatePTG(
      "CPTG_DiffDrive_C", reactiveIni(), "CReactiveNavigationSystem", "PTG0_");
  mrpt::math::CPolygon square;
  for (const auto& [x, y] : {std::pair{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}})
    square.AddVertex(x, y);
  dynamic_cast<mrpt::nav::CPTG_RobotShape_Polygonal&>(*ptg).setRobotShape(square);
  ptg->initialize("", false);
  return ptg;
}

/** MRPT's simulated robot among obstacles that are points in the map; notes MRPT's events. */
class PtgRobot : public mrpt::nav::CRobot2NavInterfaceForSimulator_DiffDriven {
 public:
  PtgRobot() : CRobot2NavInterfaceForSimulator_DiffDriven(vehicle) {
    setMinLoggingLevel(mrpt::system::LVL_ERROR);
  }

  bool senseObstacles(mrpt::maps::CSimplePointsMap& points,
                      mrpt::system::TTimeStamp& stamp) override {
    if (throwsNow) throw std::runtime_error("the laser is on fire");
    points.clear();
    const auto pose = vehicle.getCurrentGTPose();
    for (const auto& obstacle : obstacles) {
      const auto p = pose.inverseComposePoint(obstacle);
      points.insertPoint(static_cast<float>(p.x), static_cast<float>(p.y), 0.0f);
    }
    if (!frozen) seenAt = mrpt::Clock::fromDouble(1e9 + vehicle.getTime());
    stamp = seenAt;
    return sees;
  }
  bool changeSpeeds(const mrpt::kinematics::CVehicleVelCmd& command) override {
    commands.push_back(command.getVelCmdElement(0));
    return CRobot2NavInterfaceForSimulator_DiffDriven::changeSpeeds(command);
  }
  /** As the simulator's, with stamps of the simulated clock. */
  bool getCurrentPoseAndSpeeds(mrpt::math::TPose2D& pose, mrpt::math::TTwist2D& velocity,
                               mrpt::system::TTimeStamp& stamp, mrpt::math::TPose2D& odometry,
                               std::string& frame) override {
    const bool known = CRobot2NavInterfaceForSimulator_DiffDriven::getCurrentPoseAndSpeeds(
        pose, velocity, stamp, odometry, frame);
    stamp = mrpt::Clock::fromDouble(1e9 + vehicle.getTime());
    return known && !lost;
  }
  bool stop(bool isEmergencyStop) override {
    speedsAtStop.push_back(vehicle.getCurrentGTVelLocal().vx);
    return CRobot2NavInterfaceForSimulator_DiffDriven::stop(isEmergencyStop);
  }
  void sendNavigationStartEvent() override { events += "start "; }
  void sendNavigationEndEvent() override { events += "end "; }
  void sendNavigationEndDueToErrorEvent() override { events += "error "; }
  void sendWaypointReachedEvent(int index, bool) override {
    events += "reached" + std::to_string(index) + " ";
  }

  /** A wall of points. */
  void addWall(double x0, double y0, double x1, double y1) {
    const double length = std::hypot(x1 - x0, y1 - y0);
    for (double s = 0.0; s <= length; s += 0.02)
      obstacles.emplace_back(x0 + s / length * (x1 - x0), y0 + s / length * (y1 - y0));
  }

  mrpt::kinematics::CVehicleSimul_DiffDriven vehicle;
  std::vector<mrpt::math::TPoint2D> obstacles;
  std::vector<double> commands;  ///< forward speeds
  std::string events;
  std::vector<double> speedsAtStop;  ///< how fast it was when MRPT stopped it at once
  mrpt::system::TTimeStamp seenAt;
  bool sees = true, throwsNow = false, lost = false;
  bool frozen = false;  ///< it goes on giving the last obstacles with their old stamp
};

/** Steps a navigator and the robot until it arrives, fails or the time is over. */
template <typename Navigator>
void drive(Navigator& navigator, PtgRobot& robot, double seconds) {
  for (double t = 0.0; t < seconds; t += 0.1) {
    navigator.navigationStep();
    robot.vehicle.simulateOneTimeStep(0.1);
    if (navigator.getCurrentState() != Navigator::NAVIGATING) break;
  }
  navigator.navigationStep();  // MRPT sends events of the last step in the next one
}

template <typename Navigator>
void navigateTo(Navigator& navigator, double x, double y) {
  mrpt::nav::CAbstractNavigator::TNavigationParams target;
  target.target.target_coords = {x, y, 0.0};
  target.target.targetAllowedDistance = 0.2f;
  navigator.navigate(&target);
}

}  // namespace bslnav::test
