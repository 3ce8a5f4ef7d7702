#pragma once

#include <bslnav/simulation/RobotBody.h>

#include <optional>
#include <vector>

namespace bslnav {

/** The way on along `path` that leaves out a circle, around its shorter free side; map frame.
 *
 *  @param path starts in the circle, or within 2 % of its radius @param body who walks
 *  @return the path from its first point to its last, or nothing where it ends in the circle or
 *          both sides are blocked */
std::optional<std::vector<mrpt::math::TPoint2D>> wayRound(
    const std::vector<mrpt::math::TPoint2D>& path, const mrpt::math::TPoint2D& centre,
    double radius_m, RobotBody& body, const std::vector<WorldShape>& solids);

}  // namespace bslnav
