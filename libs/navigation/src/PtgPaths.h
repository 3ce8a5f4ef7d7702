#pragma once

#include <bslnav/planning/Rollout.h>
#include <mrpt/math/TTwist2D.h>
#include <mrpt/nav/tpspace/CParameterizedTrajectoryGenerator.h>

namespace bslnav {

/** The velocity that a path of a PTG is begun with at full speed, robot frame.
 *  @throws Error for a kind of command that is neither differential nor holonomic */
mrpt::math::TTwist2D commandOf(const mrpt::kinematics::CVehicleVelCmd& command);

/** Writes a velocity into a command of MRPT's, of the kind that it is. */
void setVelocity(const mrpt::math::TTwist2D& twist, mrpt::kinematics::CVehicleVelCmd& command);

/** Samples path k of a PTG, no two poses farther apart than `spacing_m`, until `reach_m` is driven
 * or the path ends. Distances are those of the robot's centre: a PTG's own also count its turning.
 */
void samplePath(const mrpt::nav::CParameterizedTrajectoryGenerator& ptg, std::uint16_t k,
                double reach_m, double spacing_m, SampledPath& path);

}  // namespace bslnav
