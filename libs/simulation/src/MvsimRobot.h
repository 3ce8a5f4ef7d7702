#pragma once

#include <bslnav/simulation/SimulationEngine.h>

#include "MvsimXml.h"

namespace bslnav {

/** The most corners of a solid that MVSim's physics takes. */
inline constexpr int kMvsimCorners = 14;

/** Writes an outline, a `<shape>`, in the frame of its owner. */
void writeShape(MvsimXml& xml, const std::vector<mrpt::math::TPoint2D>& polygon);

/** A circle around the origin as a regular polygon of `kMvsimCorners` corners, half of it outside:
 * nowhere farther than 1.3 % of the radius from the circle. */
std::vector<mrpt::math::TPoint2D> mvsimCircle(double radius_m);

/** Writes the robot, its lasers and its depth cameras where it starts.
 *  @throws Error when MVSim has no such robot */
void writeRobot(MvsimXml& xml, const SimulationCase& simulated);

}  // namespace bslnav
