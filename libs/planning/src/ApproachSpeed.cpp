#include <bslnav/planning/ApproachSpeed.h>
#include <bslnav/planning/PathDistance.h>
#include <bslnav/planning/RobotLimits.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

constexpr double kWay_m = 3.0;  // the direction of the path is that over this length

bool isMover(const TPoint2D& person, const Movers& movers, double radius_m) {
  return std::any_of(movers.begin(), movers.end(), [&](const Mover& mover) {
    return (mover.position - person).norm() <= radius_m;
  });
}

}  // namespace

double ApproachSpeed::speed_mps(const Bystanders& bystanders, const std::vector<TPoint2D>& path,
                                const mrpt::math::TPose2D& pose) const {
  if (path.empty() || bystanders.people.empty()) return maxSpeed_mps_;
  const double slow_mps = parameters_.approachShare * maxSpeed_mps_, a = robot_.deceleration_mps2;
  const double touching_m = robot_.radius_m + parameters_.radius_m;
  const double farthest_m = touching_m + personSpeed_mps_ * 2.0 * touching_m / maxSpeed_mps_;
  const TPoint2D place{pose.x, pose.y}, ahead{std::cos(pose.phi), std::sin(pose.phi)};
  const TPoint2D onPath = pointAhead(path, place, kWay_m) - place;
  const TPoint2D way = onPath * (1.0 / std::max(onPath.norm(), 1e-6));
  double speed_mps = maxSpeed_mps_;
  for (const TPoint2D& person : bystanders.people) {
    const TPoint2D to = person - place;
    const double byHeading_m = to.x * ahead.x + to.y * ahead.y - touching_m;
    const double byPath_m = to.x * way.x + to.y * way.y - touching_m;
    if (std::max(byHeading_m, byPath_m) <= 0.0 || to.norm() > farthest_m) continue;
    if (isMover(person, bystanders.movers, parameters_.radius_m)) continue;
    const double left_m = std::max(0.0, std::min(byHeading_m, byPath_m));
    const double slowing_m = left_m + 0.5 * slow_mps * slow_mps / a;
    speed_mps = std::min(speed_mps, stoppingSpeed(slowing_m, a, robot_.reaction_s));
  }
  return std::max(slow_mps, speed_mps);
}

}  // namespace bslnav
