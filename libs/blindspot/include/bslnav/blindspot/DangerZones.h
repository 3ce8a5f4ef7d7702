#pragma once

#include <bslnav/blindspot/BlindSpot.h>
#include <bslnav/config/ConfigSection.h>
#include <bslnav/costmap/DangerZone.h>
#include <mrpt/math/TPose2D.h>

#include <cmath>

namespace bslnav {

struct DangerZoneParameters {
  double shoulderWidth_m = 0.5;    ///< H_w
  double stride_m = 0.8;           ///< L, what a person needs to stop
  double offset_m = 0.2;           ///< X_off, margin
  double amplitude = 253.0;        ///< A
  double scaling_per_m = 1.0;      ///< S
  double deceleration_mps2 = 0.5;  ///< |a|; not in the section: the cycle takes it from [limits]
  double maxBearing_rad = 80.0 * M_PI / 180.0;  ///< limit of |θ^b|, below π/2

  void describe(ConfigSection& section);
};

/** The disc around the nearest place where a person could stand hidden (paper, eq. 4 to 9).
 *
 * Centre P^o = (x^b, y^b + H_w·tan θ^b) in the robot frame, radius R^o = v²/(2|a|) + L + X_off. As
 * tan θ^b diverges beside the robot and changes its sign behind it, |θ^b| is limited to
 * maxBearing_rad: the centre is moved away from the robot's axis, never across it, and by
 * H_w·tan(max_bearing) at most (2.84 m by default).
 * @param speed_mps current speed of the robot; its sign does not matter */
DangerZone dangerZone(const BlindSpot& blindSpot, const mrpt::math::TPose2D& mapFromRobot,
                      double speed_mps, const DangerZoneParameters& parameters);

}  // namespace bslnav
