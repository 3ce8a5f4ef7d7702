#include <bslnav/config/Error.h>
#include <bslnav/simulation/SimulationTruth.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace bslnav {

SimulationTruth::SimulationTruth(const WorldParameters& world, const RobotOutline& outline,
                                 const mrpt::math::TPose2D& start)
    : shapes_(worldShapes(world)), body_(outline) {
  for (const auto& [name, person] : world.pedestrians) pedestrians_.emplace_back(person);
  positions_.resize(pedestrians_.size());
  state_.people.resize(pedestrians_.size());
  state_.pose = state_.odometry = start;
  update();
  refuseStartInCollision();
}

void SimulationTruth::refuseStartInCollision() const {
  std::ostringstream where;
  where << "simulation start (" << state_.pose.x << ", " << state_.pose.y << ")";
  for (const auto& shape : shapes_)
    if (body_.clearanceTo(shape) <= 0.0)
      throw Error(where.str(), "the robot touches [" + shape.section + "]; expected a free place");
  if (state_.clearanceToPeople_m <= 0.0)
    throw Error(where.str(), "the robot touches a pedestrian; expected a free place");
}

void SimulationTruth::advance(const mrpt::math::TPose2D& pose, const mrpt::math::TTwist2D& twist,
                              const mrpt::math::TPose2D& odometry, double dt_s) {
  const auto from = state_.pose;
  const double from_s = state_.time_s;
  state_.time_s += dt_s;
  state_.pose = pose;
  state_.twist = twist;
  state_.odometry = odometry;
  for (auto& pedestrian : pedestrians_) {
    pedestrian.observeRobot({from.x, from.y}, from_s, {pose.x, pose.y}, state_.time_s);
    pedestrian.walkRound({pose.x, pose.y}, state_.time_s, shapes_);
  }
  update();
  updateContact();
}

void SimulationTruth::update() {
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

void SimulationTruth::updateContact() {
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

}  // namespace bslnav
