#include <bslnav/planning/MoverForecast.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

constexpr double kStep_s = 0.2;
constexpr double kTurns_s = 1.0;  // who follows a path does not turn for longer

}  // namespace

void MoverParameters::describe(ConfigSection& section) {
  section.number("horizon_s", horizon_s, {0.2, 30.0}, "s",
                 "people who are seen walking are taken to walk straight on for so long");
  section.number("radius_m", radius_m, kNonNegative, "m",
                 "of a person, around the middle of what is seen");
  section.number("clearance_m", clearance_m, kPositive, "m",
                 "whom the robot passes at this distance it is not in the way of");
  section.number("approach_share", approachShare, {0.1, 1.0}, "",
                 "part of its highest speed with which the robot comes to where people who are "
                 "seen standing may cross its path; 1: it does not slow down for them");
}

void MoverForecast::begin(const mrpt::math::TPose2D& mapFromRobot, const Movers& movers) {
  movers_.clear();
  const double c = std::cos(mapFromRobot.phi), s = std::sin(mapFromRobot.phi);
  const auto turned = [c, s](const mrpt::math::TPoint2D& p) {
    return mrpt::math::TPoint2D(c * p.x + s * p.y, -s * p.x + c * p.y);
  };
  for (const Mover& mover : movers) {
    const auto p = turned(mover.position - mrpt::math::TPoint2D(mapFromRobot.x, mapFromRobot.y));
    const auto v = turned(mover.velocity);
    movers_.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(v.x),
                       static_cast<float>(v.y)});
  }
}

double MoverForecast::cost(const mrpt::math::TTwist2D& command) const {
  if (movers_.empty()) return 0.0;
  const double kept = worst(command, parameters_.horizon_s);
  return kept > 0.0 ? std::min(kept, worst(command, kStep_s)) : 0.0;
}

/** The same for a velocity that is driven for a while and then braked from along its arc. */
double MoverForecast::worst(const mrpt::math::TTwist2D& command, double drivenFor_s) const {
  const double speed = std::max(1e-6, std::hypot(command.vx, command.vy));
  const double touching = robot_.radius_m + parameters_.radius_m;
  const int steps = static_cast<int>(std::ceil(parameters_.horizon_s / kStep_s));
  double x = 0.0, y = 0.0, heading = 0.0, worst = 0.0, admissible = speed;
  for (int k = 1; k <= steps; ++k) {
    const double t = k * kStep_s;
    const double braked_s = std::max(0.0, t - 0.5 * kStep_s - drivenFor_s);
    const double now = std::min(admissible, speed - robot_.deceleration_mps2 * braked_s);
    if (now > 0.0) {
      const double part = kStep_s * now / speed;
      const double turn = t <= kTurns_s ? part * command.omega : 0.0;
      const double middle = heading + 0.5 * turn;
      const double c = std::cos(middle), s = std::sin(middle);
      x += part * (c * command.vx - s * command.vy);
      y += part * (s * command.vx + c * command.vy);
      heading += turn;
    }
    double nearest = kGuardReach_m;
    for (const Relative& m : movers_)
      nearest = std::min(nearest, std::hypot(m.x + t * m.vx - x, m.y + t * m.vy - y));
    const double left = nearest - touching;
    worst = std::max(worst, 1.0 - left / (left > 0.0 ? parameters_.clearance_m : touching));
    admissible = std::min(speed, admissibleSpeed_mps(nearest));
  }
  return worst;
}

/** The guard's bound for somebody who might come from there. */
double MoverForecast::admissibleSpeed_mps(double distance_m) const {
  const double left_m = distance_m - robot_.radius_m - margin_m_;
  const double time_s = left_m / std::max(1e-3, personSpeed_mps_) - robot_.reaction_s;
  return std::max(0.0, robot_.deceleration_mps2 * time_s);
}

}  // namespace bslnav
