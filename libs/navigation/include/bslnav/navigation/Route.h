#pragma once

#include <bslnav/navigation/Surroundings.h>
#include <bslnav/planning/GlobalPlanner.h>

#include <vector>

namespace bslnav {

/** The goals of a robot, one after the other, and the global path to the next one. */
class Route {
 public:
  explicit Route(const NavigationParameters& parameters)
      : parameters_(parameters.cycle),
        costmap_(parameters.costmap),
        lookahead_m_(parameters.motion.lookahead_m),
        globalPlanner_(parameters.globalPlanner),
        costWeight_(parameters.globalPlanner.costWeight),
        guard_(parameters.guard),
        maxSpeed_mps_(parameters.limits.maxSpeed_mps),
        ability_(stoppingAbility(parameters.limits, parameters.guard,
                                 parameters.footprint.circumscribedRadius_m(),
                                 parameters.cycle.period_s)) {}

  /** Poses in the map frame; the robot passes all but the last one without stopping. */
  void setGoals(std::vector<mrpt::math::TPose2D> goals);
  bool empty() const { return goals_.empty(); }

  /** Goes on to the next goal when one is passed, and plans a new path when one is due or wanted;
   * fills the record's path. Must not be called without goals. */
  void update(const Surroundings& surroundings, bool replan, CycleRecord& record);

  /** Where the path leads to. */
  const mrpt::math::TPose2D& goal() const { return goals_[nextGoal_]; }
  /** Above 0: the goal is a waypoint, passed this near without stopping. */
  double passWithin_m() const;

 private:
  void advanceWaypoint(const CycleRecord& record);
  const CostGrid& costsFor(const Surroundings& surroundings);
  bool needsPath(const CycleRecord& record) const;
  void plan(const Surroundings& surroundings, CycleRecord& record);
  mrpt::math::TPoint2D withinReach(const mrpt::math::TPoint2D& goal,
                                   const mrpt::math::TPoint2D& robot,
                                   const Surroundings& surroundings) const;

  CycleParameters parameters_;
  CostmapParameters costmap_;
  double lookahead_m_;
  GlobalPlanner globalPlanner_;
  double costWeight_;
  GuardParameters guard_;
  double maxSpeed_mps_;
  StoppingAbility ability_;
  CostGrid guardedCosts_;
  std::vector<mrpt::math::TPose2D> goals_;
  std::size_t nextGoal_ = 0;
  bool goalsChanged_ = false;
  bool pathCutShort_ = false;  // it ends at the edge of the local map, on the way to the next goal
  double plannedAt_s_ = 0.0;
};

}  // namespace bslnav
