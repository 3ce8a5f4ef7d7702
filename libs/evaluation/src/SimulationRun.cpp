#include <bslnav/evaluation/SimulationRun.h>
#include <bslnav/navigation/Localization.h>
#include <bslnav/planning/RobotLimits.h>

#include <cmath>

namespace bslnav {
namespace {

constexpr double kMoving_mps = 0.05;  // a robot faster than this at contact is at fault

/** What the robot's sensors deliver now. */
void sense(SimulationEngine& simulator, Localization* localization, SensorFrame& frame) {
  const SimulationState& truth = simulator.state();
  frame.time_s = truth.time_s;
  frame.startTime_s = SimulationEngine::kEpoch_s;
  frame.odometry = truth.odometry;
  frame.twist = truth.twist;
  frame.scans.clear();
  for (auto& scan : simulator.senseScans()) frame.scans.push_back(std::move(scan));
  frame.depth = simulator.senseDepth();
  frame.mapFromRobot = localization ? localization->update(frame) : truth.pose;
}

/** Whether the run is over, and how. */
bool isOver(const CycleRecord& record, const SimulationState& truth, const SimulationSetup& setup,
            RunSummary& summary) {
  if (truth.contact != SimulationState::Contact::Nothing) {
    summary.outcome = Outcome::Contact;
    summary.reason = truth.contact == SimulationState::Contact::Person ? "contact with a person"
                                                                       : "contact with the world";
    summary.contact = true;
    summary.impactSpeed_mps = truth.speedAtContact_mps;
    summary.atFault = truth.speedAtContact_mps > kMoving_mps;
  } else if (record.motion.mode == MotionMode::Arrived) {
    summary.outcome = Outcome::Goal;
    summary.timeToGoal_s = truth.time_s;
  } else if (record.motion.mode == MotionMode::Failed) {
    summary.outcome = Outcome::Stuck;
    summary.reason = "gave up: " + reasonOf(record);
  } else if (truth.time_s >= setup.scenario.timeLimit_s) {
    summary.outcome = Outcome::Timeout;
    summary.reason = "not at the goal within the time limit";
  } else {
    return false;
  }
  return true;
}

/** Commands the robot to a standstill, within its limits. */
void stopRobot(SimulationEngine& simulator, const NavigationParameters& navigation) {
  const double period_s = navigation.cycle.period_s;
  const auto isMoving = [](const mrpt::math::TTwist2D& twist) {
    return std::hypot(speedOf(twist), twist.omega) > 1e-3;
  };
  for (int i = 0; i < 100 && isMoving(simulator.state().twist); ++i)
    simulator.step(brake(simulator.state().twist, navigation.limits, period_s), period_s);
}

}  // namespace

RunSummary runSimulation(const SimulationSetup& setup, std::uint64_t seed,
                         const SimulationObserver& observer, const SimulationEngines& engines) {
  setup.check();
  const auto map = setup.makeMap();
  const SimulationCase simulated = setup.simulationCase(seed);
  const auto engine = engines.make(setup.simulation.engine, simulated);
  SimulationEngine& simulator = *engine;
  const auto localization = setup.makeLocalization(map, seed);
  NavigationCycle cycle(setup.navigation, map);
  cycle.setGoals(setup.scenario.allGoals());
  for (const auto& laser : simulated.lasers) cycle.expectSensor(SensorKind::Laser, laser.first);
  for (const auto& camera : simulated.cameras) cycle.expectSensor(SensorKind::Camera, camera.first);

  RunSummary summary;
  summary.seed = seed;
  summary.method = setup.navigation.method.number;
  summary.methodName = setup.navigation.method.name;
  Metrics metrics;
  const double period_s = setup.navigation.cycle.period_s;
  try {
    for (SensorFrame frame;;) {
      sense(simulator, localization.get(), frame);
      const CycleRecord& record = cycle.step(frame);
      const SimulationState& truth = simulator.state();
      metrics.add(record, {truth.pose.x, truth.pose.y}, speedOf(truth.twist), period_s);
      const bool interrupted = observer && !observer({record, truth, cycle, frame});
      if (interrupted) summary.reason = "interrupted";
      if (interrupted || isOver(record, truth, setup, summary)) break;
      simulator.step(record.motion.command, period_s);
    }
  } catch (const std::exception& problem) {
    summary.outcome = Outcome::Error;
    summary.reason = problem.what();
  }
  summary.duration_s = simulator.state().time_s;
  if (!simulator.state().people.empty())
    summary.minClearance_m = simulator.state().minClearanceToPeople_m;
  metrics.finish(summary);
  stopRobot(simulator, setup.navigation);
  return summary;
}

}  // namespace bslnav
