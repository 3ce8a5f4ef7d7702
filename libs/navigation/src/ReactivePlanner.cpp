#include <bslnav/config/Config.h>
#include <bslnav/config/Error.h>
#include <bslnav/navigation/ReactivePlanner.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/io/vector_loadsave.h>
#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>
#include <mrpt/nav/registerAllClasses.h>

#include <cmath>
#include <filesystem>

#include "PtgPaths.h"

namespace bslnav {
namespace {

using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;

/** The message of an exception of MRPT's without its place and call stack. */
std::string messageOf(const std::exception& problem) {
  const std::string text = problem.what(), mark = "Message:";
  const auto start = text.find(mark);
  if (start == std::string::npos) return text;
  const auto first = text.find_first_not_of(' ', start + mark.size());
  return text.substr(first, text.find('\n', first) - first);
}

/** The footprint's outline as MRPT wants it: all x, then all y. A circle is a polygon around it. */
std::pair<std::string, std::string> outlineOf(const Footprint& footprint) {
  constexpr int kCorners = 16;
  auto corners = footprint.polygon;
  if (corners.empty())
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2.0 * M_PI * i / kCorners;
      const double radius = footprint.radius_m / std::cos(M_PI / kCorners);
      corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
  std::pair<std::string, std::string> outline;
  for (const auto& corner : corners) {
    outline.first += std::to_string(corner.x) + " ";
    outline.second += std::to_string(corner.y) + " ";
  }
  return outline;
}

/** How far MRPT sees obstacles. With our evaluator they serve its own stop in front of obstacles
 * only: what is farther away is judged over the cost map, which is much faster. */
double sight_m(NavigatorType type, const RobotLimits& limits, const Footprint& footprint) {
  if (type == NavigatorType::Mrpt) return 1e3;
  const double v = limits.maxSpeed_mps;
  const double braking = v * limits.response_s + 0.5 * v * v / limits.deceleration_mps2;
  return footprint.circumscribedRadius_m() + braking + 0.3;
}

/** MRPT's configuration with this robot's speeds and shape. */
mrpt::config::CConfigFileMemory configOf(const NavigatorParameters& parameters,
                                         const RobotLimits& limits, const Footprint& footprint) {
  const std::string file = dataFile(parameters.config());
  if (!std::filesystem::exists(file))
    throw Error("configuration [navigator]",
                "no such file: " + file + "; expected an INI file of MRPT's reactive navigation");
  mrpt::config::CConfigFileMemory memory(mrpt::io::file_get_contents(file));
  const double degrees = 180.0 / M_PI;
  memory.write(
      "CAbstractPTGBasedReactive", "holonomic_method",
      parameters.type == NavigatorType::Ptg ? "bslnav::CHolonomicDwa" : parameters.mrptMethod);
  memory.write("CAbstractPTGBasedReactive", "robotMax_V_mps", limits.maxSpeed_mps);
  memory.write("CAbstractPTGBasedReactive", "robotMax_W_degps", limits.maxYawRate_radps * degrees);
  const std::string navigation = "CReactiveNavigationSystem";
  memory.write(navigation, "RobotModel_circular_shape_radius", footprint.inscribedRadius_m());
  const auto [xs, ys] = outlineOf(footprint);
  memory.write(navigation, "RobotModel_shape2D_xs", xs);
  memory.write(navigation, "RobotModel_shape2D_ys", ys);
  const int ptgs = memory.read_int(navigation, "PTG_COUNT", 0, true);
  for (int i = 0; i < ptgs; ++i) {
    const std::string prefix = "PTG" + std::to_string(i) + "_";
    const double share = memory.read_double(navigation, prefix + "speed_share", 1.0);
    memory.write(navigation, prefix + "v_max_mps", share * limits.maxSpeed_mps);
    memory.write(navigation, prefix + "w_max_dps", limits.maxYawRate_radps * degrees);
    memory.write(navigation, prefix + "robot_radius", footprint.inscribedRadius_m());
  }
  return memory;
}

}  // namespace

/** What MRPT's engine asks of a robot, answered from the cycle's input. */
class ReactivePlanner::Robot : public mrpt::nav::CRobot2NavInterface {
 public:
  /** @param sight_m obstacles that are farther away are not shown to MRPT */
  explicit Robot(double sight_m) : sight_m_(sight_m) {
    setMinLoggingLevel(mrpt::system::LVL_ERROR);
  }

  /** @param costs must live as long as the navigation step */
  void set(const DwaInput& input, const CostGrid& costs) {
    pose_ = input.mapFromRobot;
    twist_ = input.twist;
    command_ = {};
    time_s_ += 0.1;  // of each cycle: MRPT asks again only when time went on
    costs_ = &costs;
  }
  const TTwist2D& command() const { return command_; }

  bool getCurrentPoseAndSpeeds(TPose2D& pose, TTwist2D& velocity, mrpt::system::TTimeStamp& stamp,
                               TPose2D& odometry, std::string& frame) override {
    pose = odometry = pose_;
    velocity = twist_.rotated(pose_.phi);
    stamp = mrpt::Clock::now();
    frame = "map";
    return true;
  }
  bool changeSpeeds(const mrpt::kinematics::CVehicleVelCmd& command) override {
    command_ = commandOf(command);
    return true;
  }
  bool changeSpeedsNOP() override { return true; }
  bool stop(bool) override {
    command_ = {};
    return true;
  }
  mrpt::kinematics::CVehicleVelCmd::Ptr getEmergencyStopCmd() override { return getStopCmd(); }
  mrpt::kinematics::CVehicleVelCmd::Ptr getStopCmd() override {
    return std::make_shared<mrpt::kinematics::CVehicleVelCmd_DiffDriven>();
  }
  bool senseObstacles(mrpt::maps::CSimplePointsMap& obstacles,
                      mrpt::system::TTimeStamp& stamp) override {
    obstacles.clear();
    const double c = std::cos(pose_.phi), s = std::sin(pose_.phi), cell = costs_->getResolution();
    for (int y = 0; y < costs_->height(); ++y)
      for (int x = 0; x < costs_->width(); ++x) {
        if (costs_->at(x, y) != kLethalCost) continue;
        const double dx = costs_->getXMin() + (x + 0.5) * cell - pose_.x;
        const double dy = costs_->getYMin() + (y + 0.5) * cell - pose_.y;
        if (dx * dx + dy * dy > sight_m_ * sight_m_) continue;
        obstacles.insertPoint(static_cast<float>(c * dx + s * dy),
                              static_cast<float>(c * dy - s * dx), 0.0f);
      }
    stamp = mrpt::Clock::now();
    return true;
  }
  double getNavigationTime() override { return time_s_; }
  void resetNavigationTimer() override {}

 private:
  double sight_m_;
  TPose2D pose_;
  TTwist2D twist_, command_;
  double time_s_ = 0.0;
  const CostGrid* costs_ = nullptr;  // of the step that runs
};

ReactivePlanner::ReactivePlanner(const NavigatorParameters& parameters, const DwaParameters& dwa,
                                 const RobotLimits& limits, const FootprintCover& cover,
                                 const Footprint& footprint, double controlPeriod_s)
    : limits_(limits),
      controlPeriod_s_(controlPeriod_s),
      robot_(std::make_unique<Robot>(sight_m(parameters.type, limits, footprint))) {
  mrpt::nav::registerAllClasses_mrpt_nav();
  navigation_ = std::make_unique<PtgNavigation>(*robot_, false);
  navigation_->use(dwa, limits, controlPeriod_s,
                   std::make_shared<CandidateEvaluator>(dwa, limits, cover));
  navigation_->silence();
  // No cache of collision grids: runs in parallel would read what others are just writing.
  navigation_->params_abstract_ptg_navigator.ptg_cache_files_directory = "/dev/null";
  try {
    navigation_->loadConfigFile(configOf(parameters, limits, footprint));
    navigation_->initialize();
    navigation_->setLogFileDirectory(parameters.navlog);
    navigation_->enableLogFile(!parameters.navlog.empty());
  } catch (const std::exception& problem) {
    throw Error(parameters.config(), "MRPT's navigation does not take it: " + messageOf(problem));
  }
}

ReactivePlanner::~ReactivePlanner() = default;

void ReactivePlanner::reset() { navigation_->cancel(); }

void ReactivePlanner::navigateTo(const DwaInput& input) {
  mrpt::nav::CWaypointsNavigator::TNavigationParamsWaypoints target;
  target.target.target_coords = {input.goal.x, input.goal.y, 0.0};
  target.target.targetAllowedDistance = 0.01f;
  target.target.targetDesiredRelSpeed = input.stopsAtGoal ? 0.05 : 1.0;
  navigation_->navigate(&target);
}

const DwaResult& ReactivePlanner::plan(const DwaInput& input, const CostGrid& costs) {
  const DwaSituation situation{input, &costs};
  robot_->set(input, costs);
  navigation_->resetNavError();
  navigation_->setSituation(&situation);
  navigateTo(input);
  navigation_->navigationStep();
  navigation_->setSituation(nullptr);
  result_ = navigation_->result();
  result_.setup.start = input.mapFromRobot;
  result_.command = limited(robot_->command(), input.twist, limits_, controlPeriod_s_);
  const bool moves = std::hypot(robot_->command().vx, robot_->command().vy) > 0.0 ||
                     robot_->command().omega != 0.0;
  result_.status = moves ? DwaResult::Status::Ok : DwaResult::Status::NoAdmissible;
  return result_;
}

}  // namespace bslnav
