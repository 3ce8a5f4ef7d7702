#include "RemainingTargets.h"

namespace bslnav {

std::vector<mrpt::math::TPose2D> remainingTargets(
    const mrpt::nav::CAbstractNavigator::TNavigationParams* parameters,
    const mrpt::nav::TWaypointStatusSequence& waypoints) {
  std::vector<mrpt::math::TPose2D> targets;
  const int current = waypoints.waypoint_index_current_goal;
  for (std::size_t i = current < 0 ? waypoints.waypoints.size() : static_cast<std::size_t>(current);
       i < waypoints.waypoints.size(); ++i) {
    const auto& waypoint = waypoints.waypoints[i];
    targets.push_back(
        {waypoint.target.x, waypoint.target.y, waypoint.target_heading.value_or(0.0)});
  }
  if (targets.empty() && parameters) targets.push_back(parameters->target.target_coords);
  return targets;
}

}  // namespace bslnav
