#include <bslnav/blindspot/DangerZones.h>

#include <algorithm>
#include <cmath>

namespace bslnav {

void DangerZoneParameters::describe(ConfigSection& section) {
  section.number("shoulder_width_m", shoulderWidth_m, kNonNegative, "m",
                 "shoulder width of a person (H_w)");
  section.number("stride_m", stride_m, kNonNegative, "m", "what a person needs to stop (L)");
  section.number("offset_m", offset_m, kNonNegative, "m",
                 "margin between robot and person (X_off)");
  section.number("amplitude", amplitude, {0.0, 253.0}, "",
                 "cost at the centre (A); the cost map caps it at 252");
  section.number("scaling_per_m", scaling_per_m, kNonNegative, "1/m",
                 "how fast the cost falls with the distance (S)");
  section.angle("max_bearing_deg", maxBearing_rad, {0.0, 89.0},
                "limit of the bearing of a blind spot, whose tangent moves the centre");
}

DangerZone dangerZone(const BlindSpot& blindSpot, const mrpt::math::TPose2D& mapFromRobot,
                      double speed_mps, const DangerZoneParameters& parameters) {
  const double bearing =
      std::clamp(blindSpot.bearing_rad, -parameters.maxBearing_rad, parameters.maxBearing_rad);
  const mrpt::math::TPoint2D centre{
      blindSpot.position.x, blindSpot.position.y + parameters.shoulderWidth_m * std::tan(bearing)};
  const double stopping_m = speed_mps * speed_mps / (2.0 * std::abs(parameters.deceleration_mps2));
  return {mapFromRobot.composePoint(centre), stopping_m + parameters.stride_m + parameters.offset_m,
          parameters.amplitude, parameters.scaling_per_m};
}

}  // namespace bslnav
