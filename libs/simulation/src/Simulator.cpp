#include <bslnav/config/Error.h>
#include <bslnav/simulation/Simulator.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace bslnav {
namespace {

constexpr double kTimeSlack_s = 1e-9;  // sums of substeps are not exact

std::vector<RayScene::Person> bodies(const WorldParameters& world) {
  std::vector<RayScene::Person> people;
  for (const auto& [name, person] : world.pedestrians)
    people.push_back({person.radius_m, person.height_m});
  return people;
}

}  // namespace

Simulator::Simulator(const WorldParameters& world, const SimulatedRobotParameters& robot,
                     const std::map<std::string, LaserParameters>& lasers,
                     const mrpt::math::TPose2D& start, const RobotOutline& outline,
                     std::uint64_t seed)
    : shapes_(worldShapes(world)),
      scene_(world, bodies(world)),
      robot_(robot, start, seed),
      body_(outline) {
  for (const auto& [name, person] : world.pedestrians) pedestrians_.emplace_back(person);
  for (const auto& [name, laser] : lasers)
    lasers_.push_back({LaserSensor(name, laser, seed), 0, {}});
  positions_.resize(pedestrians_.size());
  state_.people.resize(pedestrians_.size());
  updateState();
  refuseStartInCollision();
  takeScans();
}

void Simulator::refuseStartInCollision() const {
  std::ostringstream where;
  where << "simulation start (" << state_.pose.x << ", " << state_.pose.y << ")";
  for (const auto& shape : shapes_)
    if (body_.clearanceTo(shape) <= 0.0)
      throw Error(where.str(), "the robot touches [" + shape.section + "]; expected a free place");
  if (state_.clearanceToPeople_m <= 0.0)
    throw Error(where.str(), "the robot touches a pedestrian; expected a free place");
}

void Simulator::step(const mrpt::math::TTwist2D& command, double dt_s) {
  const int substeps = static_cast<int>(std::ceil(dt_s / kSubstep_s - kTimeSlack_s));
  for (int i = 0; i < substeps; ++i) substep(command, dt_s / substeps);
}

void Simulator::substep(const mrpt::math::TTwist2D& command, double dt_s) {
  const auto from = robot_.pose();
  const double from_s = state_.time_s;
  robot_.advance(command, dt_s);
  state_.time_s += dt_s;
  const auto& to = robot_.pose();
  for (auto& pedestrian : pedestrians_)
    pedestrian.observeRobot({from.x, from.y}, from_s, {to.x, to.y}, state_.time_s);
  updateState();
  updateContact();
  takeScans();
}

void Simulator::updateState() {
  state_.pose = robot_.pose();
  state_.twist = robot_.twist();
  state_.odometry = robot_.odometry();
  body_.moveTo(state_.pose);
  state_.clearanceToWorld_m = body_.clearanceTo(shapes_);
  state_.clearanceToPeople_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pedestrians_.size(); ++i) {
    const auto& pedestrian = pedestrians_[i];
    const double radius_m = pedestrian.parameters().radius_m;
    positions_[i] = pedestrian.position(state_.time_s);
    state_.people[i] = {positions_[i], radius_m, pedestrian.started(state_.time_s),
                        pedestrian.speed_mps(state_.time_s)};
    state_.clearanceToPeople_m =
        std::min(state_.clearanceToPeople_m, body_.clearanceTo(positions_[i], radius_m));
  }
  state_.minClearanceToPeople_m =
      std::min(state_.minClearanceToPeople_m, state_.clearanceToPeople_m);
}

void Simulator::updateContact() {
  if (state_.contact != SimulationState::Contact::Nothing) return;
  if (state_.clearanceToPeople_m <= 0.0)
    state_.contact = SimulationState::Contact::Person;
  else if (state_.clearanceToWorld_m <= 0.0)
    state_.contact = SimulationState::Contact::World;
  else
    return;
  state_.contactTime_s = state_.time_s;
  state_.speedAtContact_mps = std::abs(state_.twist.vx);
}

void Simulator::takeScans() {
  bool placed = false;
  for (auto& laser : lasers_) {
    const auto& parameters = laser.sensor.parameters();
    if (static_cast<double>(laser.taken) / parameters.rate_hz > state_.time_s + kTimeSlack_s)
      continue;
    if (!placed) scene_.placePeople(positions_);
    placed = true;
    const auto stamp = mrpt::Clock::fromDouble(kEpoch_s + state_.time_s);
    laser.pending.push_back(
        {state_.time_s + parameters.latency_s, laser.sensor.scan(scene_, state_.pose, stamp)});
    ++laser.taken;
  }
}

Simulator::Scans Simulator::senseScans() {
  Scans scans;
  for (auto& laser : lasers_) {
    const auto undelivered =
        std::find_if(laser.pending.begin(), laser.pending.end(),
                     [&](const auto& p) { return p.delivery_s > state_.time_s + kTimeSlack_s; });
    if (undelivered == laser.pending.begin()) continue;
    scans.push_back(std::prev(undelivered)->scan);
    laser.pending.erase(laser.pending.begin(), undelivered);
  }
  return scans;
}

}  // namespace bslnav
