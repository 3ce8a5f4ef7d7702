#include <bslnav/campaign/Yardstick.h>
#include <mrpt/math/TPoint2D.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

constexpr double kAlong_m = 0.1, kAcross_m = 0.05, kSpeed_mps = 0.02;
constexpr double kNever_s = std::numeric_limits<double>::infinity();

double distanceToSegment(const TPoint2D& p, const TPoint2D& a, const TPoint2D& b) {
  const TPoint2D way = b - a, to = p - a;
  const double squared = way.x * way.x + way.y * way.y;
  const double part =
      squared > 0.0 ? std::clamp((to.x * way.x + to.y * way.y) / squared, 0.0, 1.0) : 0.0;
  return (to - way * part).norm();
}

/** What can be driven where. */
class Pass {
 public:
  Pass(const CornerPass& pass, const StoppingAbility& robot, double personSpeed_mps)
      : pass_(pass), robot_(robot), personSpeed_mps_(personSpeed_mps) {}

  /** Whether the robot may be at `at` with this speed, heading along (1, slope). */
  bool isSafe(const TPoint2D& at, double slope, double speed_mps) const {
    if (speed_mps == 0.0 || at.x >= pass_.openingFrom_m) return true;  // then it sees all of it
    const TPoint2D end = endOfSight(at), corner(pass_.openingFrom_m, -pass_.right_m);
    const double hidden_m = (end - corner).norm(), from_m = whereSomebodyFits_m(end - corner);
    if (from_m >= hidden_m) return true;
    const TPoint2D begin = corner + (end - corner) * (from_m / hidden_m);
    const TPoint2D direction = TPoint2D(1.0, slope) * (1.0 / std::hypot(1.0, slope));
    const double stop_s = robot_.reaction_s + speed_mps / robot_.deceleration_mps2;
    constexpr int kSteps = 20;
    for (int k = 0; k <= kSteps; ++k) {
      const double t = stop_s * k / kSteps;
      const double needed = robot_.radius_m + personSpeed_mps_ * t;
      if (distanceToSegment(at + direction * driven_m(speed_mps, t), begin, end) <= needed)
        return false;
    }
    return true;
  }

 private:
  double driven_m(double speed_mps, double t) const {
    const double braking_s =
        std::clamp(t - robot_.reaction_s, 0.0, speed_mps / robot_.deceleration_mps2);
    return speed_mps * std::min(t, robot_.reaction_s) +
           braking_s * (speed_mps - 0.5 * robot_.deceleration_mps2 * braking_s);
  }

  /** Where the line of sight past the corner ends: at the niche's far side or its back. */
  TPoint2D endOfSight(const TPoint2D& from) const {
    const TPoint2D corner(pass_.openingFrom_m, -pass_.right_m), way = corner - from;
    const double toSide = (pass_.openingTo_m - corner.x) / way.x;
    const double toBack = way.y < 0.0 ? pass_.depth_m / -way.y : kNever_s;
    return corner + way * std::min(toSide, toBack);
  }

  /** How far behind the corner a person begins to fit between the line of sight and the niche's
   * side wall. */
  double whereSomebodyFits_m(const TPoint2D& sight) const {
    const double wedge_rad = std::atan2(sight.x, -sight.y);
    return pass_.personRadius_m / std::tan(std::max(1e-6, 0.5 * wedge_rad));
  }

  CornerPass pass_;
  StoppingAbility robot_;
  double personSpeed_mps_;
};

}  // namespace

std::optional<double> fastestPass_s(const CornerPass& pass, const StoppingAbility& robot,
                                    double acceleration_mps2, double maxSpeed_mps,
                                    double personSpeed_mps) {
  const Pass limits(pass, robot, personSpeed_mps);
  const auto right = static_cast<int>((pass.right_m - robot.radius_m) / kAcross_m);
  const auto left = static_cast<int>((pass.left_m - robot.radius_m) / kAcross_m);
  const auto fastest = static_cast<int>(maxSpeed_mps / kSpeed_mps + 1e-9);
  const auto columns = static_cast<int>(pass.goal_m / kAlong_m + 0.5);
  const auto speeds = static_cast<std::size_t>(fastest + 1);
  const auto cell = [&](int y, int v) {
    return static_cast<std::size_t>(y + right) * speeds + static_cast<std::size_t>(v);
  };
  std::vector<double> now(static_cast<std::size_t>(right + left + 1) * speeds, kNever_s);
  std::vector<double> next(now.size());
  now[cell(0, 0)] = 0.0;
  for (int x = 1; x <= columns; ++x) {
    std::fill(next.begin(), next.end(), kNever_s);
    for (int y = -right; y <= left; ++y)
      for (int v = 0; v <= fastest; ++v) {
        const double speed = v * kSpeed_mps;
        for (int turn = -1; turn <= 1; ++turn) {
          const int fromY = y - turn;
          if (fromY < -right || fromY > left) continue;
          const double slope = turn * kAcross_m / kAlong_m;
          if (!limits.isSafe({x * kAlong_m, y * kAcross_m}, slope, speed)) continue;
          const double way = kAlong_m * std::hypot(1.0, slope);
          double& best = next[cell(y, v)];
          for (int before = 0; before <= fastest; ++before) {
            const double from = before * kSpeed_mps, change = speed * speed - from * from;
            if (change > 2.0 * acceleration_mps2 * way + 1e-9) continue;
            if (-change > 2.0 * robot.deceleration_mps2 * way + 1e-9) break;
            if (before + v > 0)
              best = std::min(best, now[cell(fromY, before)] + 2.0 * way / (from + speed));
          }
        }
      }
    now.swap(next);
  }
  const double time_s = now[cell(0, 0)];
  return std::isfinite(time_s) ? std::optional<double>(time_s) : std::nullopt;
}

}  // namespace bslnav
