#include <bslnav/simulation/Simulator.h>

#include <algorithm>

namespace bslnav {
namespace {

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

}  // namespace

Simulator::Simulator(const WorldParameters& world, const SimulatedRobotParameters& robot,
                     const std::map<std::string, LaserParameters>& lasers,
                     const std::map<std::string, DepthCameraParameters>& cameras,
                     const mrpt::math::TPose2D& start, const RobotOutline& outline,
                     std::uint64_t seed)
    : scene_(world, bodies(world)), robot_(robot, start, seed), truth_(world, outline, start) {
  for (const auto& [name, laser] : lasers)
    lasers_.push_back({LaserSensor(name, laser, seed), {laser.rate_hz, laser.latency_s}});
  for (const auto& [name, camera] : cameras)
    cameras_.push_back({DepthCamera(name, camera, seed), {camera.rate_hz, camera.latency_s}});
  measure();
}

void Simulator::substep(const mrpt::math::TTwist2D& command, double dt_s) {
  robot_.advance(command, dt_s);
  truth_.advance(robot_.pose(), robot_.twist(), robot_.odometry(), dt_s);
  measure();
}

void Simulator::measure() {
  const double now_s = state().time_s;
  if (!anyDue(lasers_, now_s) && !anyDue(cameras_, now_s)) return;
  scene_.placePeople(truth_.people());
  const auto stamp = mrpt::Clock::fromDouble(kEpoch_s + now_s);
  for (auto& laser : lasers_)
    if (laser.schedule.due(now_s))
      laser.schedule.take(laser.sensor.scan(scene_, state().pose, stamp), now_s);
  for (auto& camera : cameras_)
    if (camera.schedule.due(now_s))
      camera.schedule.take(camera.sensor.frame(scene_, state().pose, stamp), now_s);
}

Simulator::Scans Simulator::senseScans() {
  return delivered<Scans::value_type>(lasers_, state().time_s);
}

Simulator::DepthFrames Simulator::senseDepth() {
  return delivered<DepthFrames::value_type>(cameras_, state().time_s);
}

}  // namespace bslnav
