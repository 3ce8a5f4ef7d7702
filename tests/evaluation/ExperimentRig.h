#pragma once

#include <bslnav/evaluation/NominalRuns.h>

#include "EvaluationRig.h"

namespace bslnav::test {

/** The noiseless hall with a person who walks off when the robot is at x = 0.5 m; over seeds that
 * speed varies by up to half. A run takes hundredths of a second. */
inline ExperimentCase hallCase(const std::string& name, int method, double goalX_m = 1.5) {
  ExperimentCase entry{name, method, hall(goalX_m), ""};
  entry.setup.scenario.name = name;
  entry.setup.scenario.speedVariation = 0.5;
  entry.setup.navigation.method.number = method;
  auto& person = entry.setup.world.pedestrians["walker"];
  person.path_m = {{3.0, 1.5}, {8.0, 1.5}};
  person.triggerLine_m = {{0.5, -1.0}, {0.5, 1.0}};
  entry.setup.pictures.snapshots_s = {1.0, 2.0, 60.0};
  return entry;
}

/** A run that reached its goal. */
inline RunSummary goalRun(int method, double time_s, double clearance_m) {
  RunSummary run;
  run.method = method;
  run.methodName = "name" + std::to_string(method);
  run.outcome = Outcome::Goal;
  run.timeToGoal_s = time_s;
  run.minClearance_m = clearance_m;
  return run;
}

/** A run that hit a person at 0.5 m/s. */
inline RunSummary contactRun(int method) {
  RunSummary run = goalRun(method, 0.0, -0.01);
  run.outcome = Outcome::Contact;
  run.timeToGoal_s.reset();
  run.contact = run.atFault = true;
  run.impactSpeed_mps = 0.5;
  return run;
}

}  // namespace bslnav::test
