#include <bslnav/navigation/Route.h>
#include <bslnav/planning/GuardCosts.h>

#include <algorithm>
#include <cmath>

namespace bslnav {

using mrpt::math::TPoint2D;

void Route::setGoals(std::vector<mrpt::math::TPose2D> goals) {
  goals_ = std::move(goals);
  nextGoal_ = 0;
  goalsChanged_ = true;
}

void Route::update(const Surroundings& surroundings, bool replan, CycleRecord& record) {
  advanceWaypoint(record);
  record.replanned = replan || needsPath(record);
  if (record.replanned) plan(surroundings, record);
}

double Route::passWithin_m() const {
  const bool waypoint = pathCutShort_ || nextGoal_ + 1 < goals_.size();
  return waypoint ? parameters_.waypointTolerance_m : 0.0;
}

void Route::advanceWaypoint(const CycleRecord& record) {
  const auto isNear = [this, &record](double x, double y) {
    const auto& pose = record.mapFromRobot;
    return std::hypot(x - pose.x, y - pose.y) <= parameters_.waypointTolerance_m;
  };
  // A waypoint in an obstacle is passed where the path ends: as near to it as one gets.
  bool passed = !goalsChanged_ && !pathCutShort_ && !record.path.empty() &&
                isNear(record.path.back().x, record.path.back().y);
  for (; nextGoal_ + 1 < goals_.size() &&
         (passed || isNear(goals_[nextGoal_].x, goals_[nextGoal_].y));
       ++nextGoal_) {
    goalsChanged_ = true;
    passed = false;
  }
}

bool Route::needsPath(const CycleRecord& record) const {
  const auto& pose = record.mapFromRobot;
  const bool atCut =
      pathCutShort_ && !record.path.empty() &&
      std::hypot(record.path.back().x - pose.x, record.path.back().y - pose.y) < lookahead_m_;
  return goalsChanged_ || atCut ||
         record.time_s - plannedAt_s_ >= parameters_.replanPeriod_s - 1e-6;
}

void Route::plan(const Surroundings& surroundings, CycleRecord& record) {
  record.path.clear();
  goalsChanged_ = false;
  plannedAt_s_ = record.time_s;
  const TPoint2D robot{record.mapFromRobot.x, record.mapFromRobot.y};
  const TPoint2D goal{goals_[nextGoal_].x, goals_[nextGoal_].y};
  const TPoint2D reachable = withinReach(goal, robot, surroundings);
  pathCutShort_ = (reachable - goal).norm() > 0.0;
  const PathResult path = globalPlanner_.plan(costsFor(surroundings), robot, reachable);
  record.pathStatus = path.status;
  record.goalMoved = path.goalMoved;
  record.path.assign(path.points.begin(), path.points.end());
}

/** With a guard, places near to what nobody can see into cost the time that passing them slowly
 * takes. */
const CostGrid& Route::costsFor(const Surroundings& surroundings) {
  const People* people = surroundings.people();
  if (!people || people->frontier().empty()) return surroundings.planningCosts();
  guardedCosts_ = surroundings.planningCosts();
  addGuardCosts(people->frontier(), guard_, ability_, maxSpeed_mps_, costWeight_, guardedCosts_);
  return guardedCosts_;
}

TPoint2D Route::withinReach(const TPoint2D& goal, const TPoint2D& robot,
                            const Surroundings& surroundings) const {
  const CostGrid& grid = surroundings.planningCosts();
  if (surroundings.hasMap() || grid.bounds().contains(grid.cellX(goal.x), grid.cellY(goal.y)))
    return goal;
  const double side = std::min(costmap_.width_m, costmap_.height_m);
  const double margin = 0.5 * side - 2.0 * grid.getResolution();
  const TPoint2D way = goal - robot;
  return robot + way * (margin / std::max(std::abs(way.x), std::abs(way.y)));
}

}  // namespace bslnav
