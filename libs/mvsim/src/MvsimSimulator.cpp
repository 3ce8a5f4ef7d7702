#include <bslnav/config/Config.h>
#include <bslnav/config/Error.h>
#include <bslnav/mvsim/MvsimSimulator.h>

#include <cmath>

#include "HeadlessWorld.h"

namespace bslnav {
namespace {

const SimulationCase& withoutCameras(const SimulationCase& simulated) {
  if (!simulated.cameras.empty())
    Config::refuse("simulation", "engine",
                   "builtin when [depth] enabled: MVSim's depth cameras need a graphics context");
  return simulated;
}

}  // namespace

struct MvsimSimulator::World : HeadlessWorld {
  using HeadlessWorld::HeadlessWorld;
};

MvsimSimulator::MvsimSimulator(const SimulationCase& simulated)
    : truth_(withoutCameras(simulated).world, simulated.outline, simulated.start),
      world_(std::make_unique<World>(simulated)) {
  for (const auto& [name, laser] : simulated.lasers)
    lasers_.push_back({LaserSensor(name, laser, simulated.seed), {laser.rate_hz, laser.latency_s}});
  measure();
}

MvsimSimulator::~MvsimSimulator() = default;

void MvsimSimulator::substep(const mrpt::math::TTwist2D& command, double dt_s) {
  if (!std::isfinite(command.vx) || !std::isfinite(command.omega))
    throw Error("MVSim's robot", "a command is not a finite number", Error::Kind::Run);
  world_->advance(command, dt_s);
  truth_.advance(world_->pose(), world_->twist(), state().odometry + world_->wheelTwist() * dt_s,
                 dt_s);
  world_->placePeople(truth_.people());
  measure();
}

void MvsimSimulator::measure() {
  const double now_s = state().time_s;
  for (std::size_t i = 0; i < lasers_.size(); ++i) {
    auto& [sensor, schedule] = lasers_[i];
    if (!schedule.due(now_s)) continue;
    const auto stamp = mrpt::Clock::fromDouble(kEpoch_s + now_s);
    schedule.take(sensor.scan(world_->distances(i), stamp), now_s);
  }
}

MvsimSimulator::Scans MvsimSimulator::senseScans() {
  return delivered<Scans::value_type>(lasers_, state().time_s);
}

}  // namespace bslnav
