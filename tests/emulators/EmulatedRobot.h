#pragma once

#include <bslnav/simulation/Simulator.h>

#include <atomic>
#include <mutex>
#include <thread>

#include "CreateEmulator.h"
#include "ScipEmulator.h"

namespace bslnav::test {

/** A Create 2 with a SCIP laser in a simulated world, in real time: drivers of both find what they
 * find on a robot. */
class EmulatedRobot {
 public:
  /** The case's lasers are replaced by the SCIP one, at the place of the first. */
  EmulatedRobot(SimulationCase simulated, const ScipModel& model, double wheelBase_m);
  ~EmulatedRobot();

  CreateEmulator& base() { return base_; }
  ScipEmulator& laser() { return laser_; }
  SimulationState state() const;

  void startMeasuring();
  /** The way that the robot has made since, by its wheels. */
  double driven_m() const;

 private:
  void run();
  void step(double dt_s);

  const double wheelBase_m_;
  Simulator simulator_;
  CreateEmulator base_;
  ScipEmulator laser_;
  mutable std::mutex mutex_;  // for the simulator and what follows
  double driven_m_ = 0.0;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace bslnav::test
