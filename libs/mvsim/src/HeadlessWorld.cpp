#include "HeadlessWorld.h"

#include <bslnav/config/Error.h>
#include <bslnav/simulation/MvsimWorld.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <limits>

namespace bslnav {
namespace {

/** The world file with exact lasers: their noise is added afterwards, from the run's seed. */
std::string exactWorld(SimulationCase simulated) {
  for (auto& [name, laser] : simulated.lasers) laser.noiseStd_m = 0.0;
  return mvsimWorld(simulated);
}

}  // namespace

HeadlessWorld::HeadlessWorld(const SimulationCase& simulated)
    : scansTaken_(simulated.lasers.size()) {
  std::string xml = exactWorld(simulated);  // MVSim writes into the text
  world_.setMinLoggingLevel(mrpt::system::LVL_ERROR);
  world_.getTimeLogger().enable(false);
  world_.headless(true);
  try {
    world_.load_from_XML(xml);
  } catch (const std::exception& problem) {
    throw Error("MVSim", problem.what(), Error::Kind::Run);
  }
  for (const auto& person : simulated.world.pedestrians)
    people_.push_back(world_.getListOfBlocks().find(mvsimPersonName(person.first))->second);
  world_.registerCallbackOnObservation(
      [this](const mvsim::Simulable&, const mrpt::obs::CObservation::Ptr& observation) {
        newest_ = std::dynamic_pointer_cast<mrpt::obs::CObservation2DRangeScan>(observation);
      });
  // Contact moves nothing, as in our simulator: it is judged with the exact outlines.
  vehicle().get_fixture_chassis()->SetSensor(true);
  for (b2Fixture* wheel : vehicle().get_fixture_wheels()) wheel->SetSensor(true);
  world_.run_simulation(1e-6);  // too short for a step: MVSim only sets the start of its clock
}

void HeadlessWorld::advance(const mrpt::math::TTwist2D& command, double dt_s) {
  // MVSim's clock stands still, so that its lasers are not due before distances() asks for them.
  world_.force_set_simul_time(0.0);
  world_.set_simul_timestep(dt_s);
  vehicle().getControllerInterface()->setTwistCommand({command.vx, 0.0, command.omega});
  world_.run_simulation(dt_s);
}

void HeadlessWorld::placePeople(const std::vector<mrpt::math::TPoint2D>& positions) {
  for (std::size_t i = 0; i < people_.size(); ++i) {
    const auto& p = positions[i];
    people_[i]->setPose({p.x, p.y, 0.0, 0.0, 0.0, 0.0});
    people_[i]->getBox2DBlockBody()->SetTransform(
        {static_cast<float>(p.x), static_cast<float>(p.y)}, 0.0f);
  }
}

const std::vector<float>& HeadlessWorld::distances(std::size_t laser) {
  auto& sensor = *vehicle().getSensors().at(laser);
  mvsim::TSimulContext context;
  context.b2_world = world_.getBox2DWorld().get();
  context.world = &world_;
  context.simul_time = ++scansTaken_.at(laser) * sensor.sensor_period();  // due exactly now
  sensor.simul_post_timestep(context);
  distances_m_.resize(newest_->getScanSize());
  for (std::size_t i = 0; i < distances_m_.size(); ++i)
    distances_m_[i] = newest_->getScanRangeValidity(i) ? newest_->getScanRange(i)
                                                       : std::numeric_limits<float>::infinity();
  return distances_m_;
}

mrpt::math::TPose2D HeadlessWorld::pose() const {
  const auto pose = vehicle().getPose();
  return {pose.x, pose.y, pose.yaw};
}

}  // namespace bslnav
