#include "EmulatedRobot.h"

#include <chrono>
#include <cmath>
#include <limits>

namespace bslnav::test {
namespace {

constexpr double kStep_s = 0.01;

/** The SCIP laser where the case has its first one. */
SimulationCase withLaser(SimulationCase simulated, const ScipModel& model) {
  LaserParameters laser = model.simulated();
  if (!simulated.lasers.empty()) {
    const LaserParameters& first = simulated.lasers.begin()->second;
    laser.x_m = first.x_m;
    laser.y_m = first.y_m;
    laser.z_m = first.z_m;
    laser.noiseStd_m = first.noiseStd_m;
  }
  simulated.lasers = {{"scip", laser}};
  return simulated;
}

}  // namespace

EmulatedRobot::EmulatedRobot(SimulationCase simulated, const ScipModel& model, double wheelBase_m)
    : wheelBase_m_(wheelBase_m),
      simulator_(withLaser(std::move(simulated), model)),
      laser_(model),
      thread_([this] { run(); }) {}

EmulatedRobot::~EmulatedRobot() {
  ending_ = true;
  thread_.join();
}

SimulationState EmulatedRobot::state() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return simulator_.state();
}

void EmulatedRobot::startMeasuring() {
  const std::lock_guard<std::mutex> lock(mutex_);
  driven_m_ = 0.0;
}

double EmulatedRobot::driven_m() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return driven_m_;
}

/** As many steps as time has passed: a machine that is late catches up, a tenth of a second at
 * most. */
void EmulatedRobot::run() {
  using Clock = std::chrono::steady_clock;
  auto due = Clock::now();
  const auto period =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(kStep_s));
  while (!ending_) {
    std::this_thread::sleep_until(due);
    due = std::max(due + period, Clock::now() - 10 * period);
    step(kStep_s);
  }
}

void EmulatedRobot::step(double dt_s) {
  const auto wheels = base_.wheels();
  const std::lock_guard<std::mutex> lock(mutex_);
  const mrpt::math::TPose2D before = simulator_.state().odometry;
  simulator_.step({0.5 * (wheels.left_mps + wheels.right_mps), 0.0,
                   (wheels.right_mps - wheels.left_mps) / wheelBase_m_},
                  dt_s);
  const mrpt::math::TPose2D moved = simulator_.state().odometry - before;
  const double ahead_m = std::copysign(std::hypot(moved.x, moved.y), moved.x);
  base_.moved(ahead_m - 0.5 * wheelBase_m_ * moved.phi, ahead_m + 0.5 * wheelBase_m_ * moved.phi);
  driven_m_ += std::abs(ahead_m);
  for (const auto& scan : simulator_.senseScans()) {
    std::vector<float> ranges(scan->getScanSize(), std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < ranges.size(); ++i)
      if (scan->getScanRangeValidity(i)) ranges[i] = scan->getScanRange(i);
    laser_.setRanges(std::move(ranges));
  }
}

}  // namespace bslnav::test
