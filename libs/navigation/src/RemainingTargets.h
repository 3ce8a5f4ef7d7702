#pragma once

#include <mrpt/nav/reactive/CWaypointsNavigator.h>

#include <vector>

namespace bslnav {

/** Where MRPT's navigation is to lead: the waypoints from the current one on, or the one target. A
 * waypoint without heading points to where it is reached from. */
std::vector<mrpt::math::TPose2D> remainingTargets(
    const mrpt::nav::CAbstractNavigator::TNavigationParams* parameters,
    const mrpt::nav::TWaypointStatusSequence& waypoints);

}  // namespace bslnav
