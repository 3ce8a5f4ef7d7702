#include "EncounterBuilder.h"

#include <algorithm>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

constexpr double kBehindStart_m = 1.5;
constexpr double kSlowRobot_mps = 0.2, kFastRobot_mps = 0.55;  // on its way to the meeting
constexpr double kNearRobot_m = 0.7;  // who yields keeps this distance between the centres

std::string numbered(const std::string& name, std::size_t count) {
  return name + "_" + std::to_string(count + 1);
}

/** A wall along x at `y_m`, with its niches towards `outwards` (1: to the left). */
std::vector<TPoint2D> wallWithOpenings(double length_m, double y_m, double outwards,
                                       const std::vector<Opening>& openings) {
  std::vector<TPoint2D> points{{-kBehindStart_m, y_m}};
  for (const Opening& opening : openings) {
    const double from = opening.x_m - 0.5 * opening.width_m;
    const double to = opening.x_m + 0.5 * opening.width_m;
    const double end = y_m + outwards * opening.depth_m;
    points.insert(points.end(), {{from, y_m}, {from, end}, {to, end}, {to, y_m}});
  }
  points.emplace_back(length_m, y_m);
  return points;
}

}  // namespace

double lengthOf(const std::vector<TPoint2D>& points_m) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < points_m.size(); ++i)
    length_m += (points_m[i] - points_m[i - 1]).norm();
  return length_m;
}

void EncounterBuilder::wall(std::vector<TPoint2D> points_m) {
  auto& walls = encounter_.world.walls;
  walls[numbered("wall", walls.size())].points_m = std::move(points_m);
}

void EncounterBuilder::box(const BoxParameters& box) {
  auto& boxes = encounter_.world.boxes;
  boxes[numbered("box", boxes.size())] = box;
}

void EncounterBuilder::cylinder(const CylinderParameters& cylinder) {
  auto& cylinders = encounter_.world.cylinders;
  cylinders[numbered("cylinder", cylinders.size())] = cylinder;
}

void EncounterBuilder::corridor(const CorridorPlan& plan) {
  wall(wallWithOpenings(plan.length_m, -plan.right_m, -1.0, plan.rightOpenings));
  wall(wallWithOpenings(plan.length_m, plan.left_m, 1.0, plan.leftOpenings));
  for (const double x : {-kBehindStart_m, plan.length_m})
    wall({{x, -plan.right_m}, {x, plan.left_m}});
}

void EncounterBuilder::person(std::vector<TPoint2D> path_m, const Meeting& meeting) {
  PedestrianParameters person;
  person.path_m = std::move(path_m);
  person.speed_mps = dice_.between(parameters_.slowest_mps, parameters_.fastest_mps);
  if (parameters_.yield) {
    person.yieldsWithin_m = kNearRobot_m;
    person.walksRoundAfter_s = parameters_.patience_s;
  }
  startInTime(person, meeting);
  if (dice_.chance(parameters_.hesitate_share)) hesitate(person, meeting);
  auto& people = encounter_.world.pedestrians;
  people[numbered("person", people.size())] = person;
}

void EncounterBuilder::startInTime(PedestrianParameters& person, const Meeting& meeting) {
  const double robot_mps = dice_.between(kSlowRobot_mps, kFastRobot_mps);
  const double spread_s = parameters_.timingSpread_s;
  const double start_s = meeting.robot_m / robot_mps - meeting.person_m / person.speed_mps +
                         dice_.between(-spread_s, spread_s);
  constexpr double kSoonest_m = 0.05, kWide_m = 20.0;  // across everything that is built here
  const double trigger_m = std::max(kSoonest_m, start_s * robot_mps);
  person.triggerLine_m = {{trigger_m, -kWide_m}, {trigger_m, kWide_m}};
}

void EncounterBuilder::hesitate(PedestrianParameters& person, const Meeting& meeting) {
  const double where_m = meeting.person_m * dice_.between(0.4, 1.1);
  const double length_m = lengthOf(person.path_m);
  person.pauseAfter_m = std::min(where_m, 0.95 * length_m);
  person.pause_s = dice_.chance(0.5) ? dice_.between(0.5, 2.0) : dice_.between(3.0, 8.0);
  if (!dice_.chance(0.3) || person.path_m.size() != 2) return;
  const TPoint2D from = person.path_m[0], way = person.path_m[1] - person.path_m[0];
  person.path_m = {from, from + way * (person.pauseAfter_m / length_m), from};  // turns back there
}

}  // namespace bslnav
