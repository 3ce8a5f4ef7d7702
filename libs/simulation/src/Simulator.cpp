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

template <typename Sensors>
bool anyDue(const Sensors& sensors, double time_s) {
  return std::any_of(sensors.begin(), sensors.end(),
                     [time_s](const auto& sensor) { return sensor.schedule.due(time_s); });
}

/** What arrived from each sensor since the last call, in the sensors' order. */
template <typename Measurement, typename Sensors>
std::vector<Measurement> delivered(Sensors& sensors, double time_s) {
  std::vector<Measurement> measurements;
  for (auto& sensor : sensors)
    if (auto measurement = sensor.schedule.deliver(time_s))
      measurements.push_back(std::move(measurement));
  return measurements;
}

}  // namespace

Simulator::Simulator(const WorldParameters& world, const SimulatedRobotParameters& robot,
                     const std::map<std::string, LaserParameters>& lasers,
                     const std::map<std::string, DepthCameraParameters>& cameras,
                     const mrpt::math::TPose2D& start, const RobotOutline& outline,
                     std::uint64_t seed)
    : shapes_(worldShapes(world)),
      scene_(world, bodies(world)),
      robot_(robot, start, seed),
      body_(outline) {
  for (const auto& [name, person] : world.pedestrians) pedestrians_.emplace_back(person);
  for (const auto& [name, laser] : lasers)
    lasers_.push_back({LaserSensor(name, laser, seed), {laser.rate_hz, laser.latency_s}});
  for (const auto& [name, camera] : cameras)
    cameras_.push_back({DepthCamera(name, camera, seed), {camera.rate_hz, camera.latency_s}});
  positions_.resize(pedestrians_.size());
  state_.people.resize(pedestrians_.size());
  updateState();
  refuseStartInCollision();
  measure();
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
  measure();
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
  state_.speedAtContact_mps = std::hypot(state_.twist.vx, state_.twist.vy);
}

void Simulator::measure() {
  const double now_s = state_.time_s;
  if (!anyDue(lasers_, now_s) && !anyDue(cameras_, now_s)) return;
  scene_.placePeople(positions_);
  const auto stamp = mrpt::Clock::fromDouble(kEpoch_s + now_s);
  for (auto& laser : lasers_)
    if (laser.schedule.due(now_s))
      laser.schedule.take(laser.sensor.scan(scene_, state_.pose, stamp), now_s);
  for (auto& camera : cameras_)
    if (camera.schedule.due(now_s))
      camera.schedule.take(camera.sensor.frame(scene_, state_.pose, stamp), now_s);
}

Simulator::Scans Simulator::senseScans() {
  return delivered<Scans::value_type>(lasers_, state_.time_s);
}

Simulator::DepthFrames Simulator::senseDepth() {
  return delivered<DepthFrames::value_type>(cameras_, state_.time_s);
}

}  // namespace bslnav
