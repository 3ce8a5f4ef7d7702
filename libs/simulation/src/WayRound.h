#pragma once

#include <bslnav/simulation/RobotBody.h>

#include <optional>
#include <vector>

namespace bslnav {

/** A path led around a circle at its start, on the shorter free side; map frame.
 *
 *  @param path starts in the circle or just outside it @param walker who walks, from above
 *  @param solids are kept clear of around the circle; the rest of the path is taken as it is
 *  @return the path to its last point, or nothing where it does not leave the circle or both sides
 *          are blocked */
std::optional<std::vector<mrpt::math::TPoint2D>> wayRound(
    const std::vector<mrpt::math::TPoint2D>& path, const mrpt::math::TPoint2D& centre,
    double radius_m, const RobotOutline& walker, const std::vector<WorldShape>& solids);

}  // namespace bslnav
