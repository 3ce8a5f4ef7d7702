#pragma once

#include <bslnav/config/Error.h>
#include <bslnav/evaluation/SimulationRun.h>
#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace bslnav::test {

/** The setup of case S1 as its files say, with one of the methods. */
inline SimulationSetup s1(int method, const std::vector<std::string>& overrides = {}) {
  SimulationSetup setup;
  Config config;
  setup.bind(config);
  const std::string dir = BSLNAV_SOURCE_DIR "/config/";
  config.load({dir + "scenarios/s1.ini", dir + "methods/method" + std::to_string(method) + ".ini"},
              overrides);
  return setup;
}

/** An empty hall of 14 m × 4 m without noise; the robot drives from (0, 0) along x. */
inline SimulationSetup hall(double goalX_m = 5.0) {
  SimulationSetup setup;
  setup.world.walls["hall"].points_m = {{-5, -2}, {9, -2}, {9, 2}, {-5, 2}, {-5, -2}};
  setup.scenario.goals = {{goalX_m, 0.0, 0.0}};
  setup.navigation.dwa.weights.velocity = 0.0;
  auto& laser = setup.lasers["front"];
  laser.noiseStd_m = laser.dropoutProbability = 0.0;
  setup.simulatedRobot.lag_s = 0.0;
  setup.simulatedRobot.maxAcceleration_mps2 = setup.simulatedRobot.maxDeceleration_mps2 = 1e3;
  return setup;
}

/** What throws as an Error says; "" when it does not. */
inline std::string errorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

inline std::string textOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::vector<std::string> linesOf(const std::string& file) {
  std::istringstream stream(textOf(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/** Everything of a summary that must not differ between repetitions. */
inline std::string resultOf(const RunSummary& s) {
  std::ostringstream out;
  out.precision(17);
  out << nameOf(s.outcome) << ' ' << s.reason << ' ' << s.timeToGoal_s.value_or(-1.0) << ' '
      << s.duration_s << ' ' << s.pathLength_m << ' ' << s.timeStopped_s << ' ' << s.contact << ' '
      << s.atFault << ' ' << s.impactSpeed_mps.value_or(-1.0) << ' '
      << s.minClearance_m.value_or(-1.0) << ' ' << s.blindSpotsMean << ' ' << s.cycles << ' '
      << s.blockedCycles << ' ' << s.unhealthyCycles << ' ' << s.droppedBeams;
  return out.str();
}

}  // namespace bslnav::test
