#include <bslnav/planning/MoverForecast.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

constexpr double kStep_s = 0.2;

}  // namespace

void MoverParameters::describe(ConfigSection& section) {
  section.number("horizon_s", horizon_s, {0.2, 30.0}, "s",
                 "people who are seen walking are taken to walk straight on for so long");
  section.number("radius_m", radius_m, kNonNegative, "m",
                 "of a person, around the middle of what is seen");
  section.number("clearance_m", clearance_m, kPositive, "m",
                 "whom the robot passes at this distance it is not in the way of");
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
  const double turn = command.omega * kStep_s;
  const double cosine = std::cos(turn), sine = std::sin(turn);
  const double chord = std::abs(turn) < 1e-6 ? 1.0 : std::sin(0.5 * turn) / (0.5 * turn);
  const double c = std::cos(0.5 * turn), s = std::sin(0.5 * turn);
  double dx = chord * kStep_s * (c * command.vx - s * command.vy);
  double dy = chord * kStep_s * (s * command.vx + c * command.vy);
  double x = 0.0, y = 0.0, worst = 0.0;
  const double touching = robotRadius_m_ + parameters_.radius_m;
  const int steps = static_cast<int>(std::ceil(parameters_.horizon_s / kStep_s));
  for (int k = 1; k <= steps; ++k) {
    x += dx;
    y += dy;
    const double turnedX = cosine * dx - sine * dy;
    dy = sine * dx + cosine * dy;
    dx = turnedX;
    const double t = k * kStep_s;
    for (const Relative& m : movers_) {
      const double left = std::hypot(m.x + t * m.vx - x, m.y + t * m.vy - y) - touching;
      if (left >= parameters_.clearance_m) continue;
      if (left <= 0.0) return 2.0 - t / (steps * kStep_s);  // the first to meet the robot
      worst = std::max(worst, 1.0 - left / parameters_.clearance_m);
    }
  }
  return worst;
}

}  // namespace bslnav
