#include <bslnav/planning/RobotLimits.h>
#include <bslnav/planning/Rollout.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

/** The chord of one step of an arc and its rotation from step to step, in cells of the grid: exact
 * at every step, without a sine or cosine in the loop. */
struct ArcStepper {
  float x, y, dx, dy, headingCos, headingSin, turnCos, turnSin, inverseChordSquared;
  int steps;

  ArcStepper(const mrpt::math::TTwist2D& twist, const RolloutSetup& setup, const CostGrid& grid) {
    // The chord of a lateral velocity is turned by its direction and has its length.
    const double v = speedOf(twist), w = twist.omega;
    const double course =
        setup.start.phi + (twist.vy == 0.0 ? 0.0 : std::atan2(twist.vy, twist.vx));
    const double cells = 1.0 / grid.getResolution();
    const double way = (std::abs(v) + std::abs(w) * setup.outlineReach_m) * setup.horizon_s;
    steps = static_cast<int>(
        std::ceil(std::max({1.0, setup.horizon_s / setup.step_s, way * cells}) - 1e-9));
    const double dt = setup.horizon_s / steps, half = 0.5 * w * dt;
    const double chord = v * dt * cells * (std::abs(half) < 1e-9 ? 1.0 : std::sin(half) / half);
    x = static_cast<float>((setup.start.x - grid.getXMin()) * cells);
    y = static_cast<float>((setup.start.y - grid.getYMin()) * cells);
    dx = static_cast<float>(chord * std::cos(course + half));
    dy = static_cast<float>(chord * std::sin(course + half));
    headingCos = static_cast<float>(std::cos(setup.start.phi));
    headingSin = static_cast<float>(std::sin(setup.start.phi));
    turnCos = static_cast<float>(std::cos(2.0 * half));
    turnSin = static_cast<float>(std::sin(2.0 * half));
    const float chordSquared = dx * dx + dy * dy;
    inverseChordSquared = chordSquared > 0.0f ? 1.0f / chordSquared : 0.0f;
  }

  void advance() {
    x += dx;
    y += dy;
  }
  void turnChord() { rotate(dx, dy); }
  void turnHeading() { rotate(headingCos, headingSin); }

 private:
  void rotate(float& a, float& b) const {
    const float old = a;
    a = turnCos * a - turnSin * b;
    b = turnSin * old + turnCos * b;
  }
};

/** The same steps along a path of poses, the last one cut where `reach_m` is driven. */
struct PathStepper {
  float x, y, dx = 0.0f, dy = 0.0f, headingCos, headingSin, inverseChordSquared = 0.0f;
  int steps;

  PathStepper(const SampledPath& path, double reach_m, const RolloutSetup& setup,
              const CostGrid& grid)
      : x(static_cast<float>((setup.start.x - grid.getXMin()) / grid.getResolution())),
        y(static_cast<float>((setup.start.y - grid.getYMin()) / grid.getResolution())),
        headingCos(static_cast<float>(std::cos(setup.start.phi))),
        headingSin(static_cast<float>(std::sin(setup.start.phi))),
        path_(path),
        reach_(static_cast<float>(reach_m)),
        x0_(x),
        y0_(y),
        cosine0_(headingCos),
        sine0_(headingSin),
        cells_(static_cast<float>(1.0 / grid.getResolution())) {
    const auto& distance = path.distance_m;
    const auto beyond = std::lower_bound(distance.begin() + 1, distance.end(), reach_);
    steps = static_cast<int>(std::min(beyond, distance.end() - 1) - distance.begin());
  }

  void advance() {
    const auto i = static_cast<std::size_t>(++index_);
    const float step = path_.distance_m[i] - path_.distance_m[i - 1];
    part_ = step > 0.0f ? std::clamp((reach_ - path_.distance_m[i - 1]) / step, 0.0f, 1.0f) : 1.0f;
    const float u = between(path_.x_m, i) * cells_, v = between(path_.y_m, i) * cells_;
    const float nextX = x0_ + cosine0_ * u - sine0_ * v, nextY = y0_ + sine0_ * u + cosine0_ * v;
    dx = nextX - x;
    dy = nextY - y;
    x = nextX;
    y = nextY;
    const float chordSquared = dx * dx + dy * dy;
    inverseChordSquared = chordSquared > 0.0f ? 1.0f / chordSquared : 0.0f;
  }
  void turnChord() {}  // advance() finds it
  void turnHeading() {
    const auto i = static_cast<std::size_t>(index_);
    const float c = between(path_.cosine, i), s = between(path_.sine, i);
    headingCos = cosine0_ * c - sine0_ * s;
    headingSin = sine0_ * c + cosine0_ * s;
  }

 private:
  float between(const std::vector<float>& values, std::size_t i) const {
    return values[i - 1] + part_ * (values[i] - values[i - 1]);
  }

  const SampledPath& path_;
  float reach_, x0_, y0_, cosine0_, sine0_, cells_, part_ = 1.0f;
  int index_ = 0;
};

/** Tells when a rollout has come abeam of the goal within the tolerance, and where. */
class GoalPass {
 public:
  GoalPass(const RolloutSetup& setup, const CostGrid& grid)
      : x_(static_cast<float>((setup.goal.x - grid.getXMin()) / grid.getResolution())),
        y_(static_cast<float>((setup.goal.y - grid.getYMin()) / grid.getResolution())) {
    const double tolerance = setup.goalTolerance_m / grid.getResolution();
    toleranceSquared_ = static_cast<float>(tolerance * tolerance);
  }

  /** Whether the step to where the arc is now passed the goal; moves the arc back to the nearest
   * point of that step if so. */
  template <typename Stepper>
  bool passed(Stepper& arc) const {
    const float left = (x_ - arc.x) * arc.dx + (y_ - arc.y) * arc.dy;
    if (left > 0.0f) return false;
    const float back = std::max(-1.0f, left * arc.inverseChordSquared);
    const float x = arc.x + back * arc.dx, y = arc.y + back * arc.dy;
    if (!near(x, y)) return false;
    arc.x = x;
    arc.y = y;
    return true;
  }
  bool near(float x, float y) const {
    return (x - x_) * (x - x_) + (y - y_) * (y - y_) <= toleranceSquared_;
  }

 private:
  float x_, y_, toleranceSquared_;
};

template <bool kHasOutline, bool kEndsAtGoal, typename Stepper>
RolloutOutcome run(Stepper arc, const RolloutSetup& setup, const CostGrid& costs,
                   const FootprintCover& footprint) {
  using End = RolloutOutcome::End;
  const auto width = static_cast<float>(costs.width()), height = static_cast<float>(costs.height());
  const Cost* cells = costs.row(0);
  const int stride = costs.width();
  const GoalPass goal(setup, costs);
  End end = End::Horizon;
  Cost highest = kFreeCost;
  int steps = 0;
  while (steps < arc.steps && end == End::Horizon) {
    arc.advance();
    ++steps;
    if (kEndsAtGoal && goal.passed(arc)) {
      end = End::Goal;
      break;
    }
    arc.turnChord();
    const bool inside = arc.x >= 0.0f && arc.y >= 0.0f && arc.x < width && arc.y < height;
    const Cost cost =
        inside ? cells[static_cast<int>(arc.y) * stride + static_cast<int>(arc.x)] : kUnknownCost;
    if (cost < kInscribedCost) {
      highest = std::max(highest, cost);
    } else if (cost != kUnknownCost) {
      end = End::Obstacle;
    } else if (!setup.allowUnknown) {
      end = End::Unknown;
    }
    if (kHasOutline) {
      arc.turnHeading();
      if (footprint.touches(costs, arc.x, arc.y, arc.headingCos, arc.headingSin, cost))
        end = End::Obstacle;
    }
  }
  if (kEndsAtGoal && end == End::Horizon && goal.near(arc.x, arc.y)) end = End::Goal;
  return {{costs.getXMin() + static_cast<double>(arc.x) * costs.getResolution(),
           costs.getYMin() + static_cast<double>(arc.y) * costs.getResolution()},
          highest,
          steps,
          end};
}

template <typename Stepper>
RolloutOutcome runWhatIsNeeded(const Stepper& stepper, const RolloutSetup& setup,
                               const CostGrid& costs, const FootprintCover& footprint) {
  if (setup.goalTolerance_m > 0.0)
    return footprint.empty() ? run<false, true>(stepper, setup, costs, footprint)
                             : run<true, true>(stepper, setup, costs, footprint);
  return footprint.empty() ? run<false, false>(stepper, setup, costs, footprint)
                           : run<true, false>(stepper, setup, costs, footprint);
}

}  // namespace

void SampledPath::clear() {
  for (auto* values : {&x_m, &y_m, &cosine, &sine, &distance_m}) values->clear();
}

void SampledPath::add(const mrpt::math::TPose2D& pose, double drivenSoFar_m) {
  x_m.push_back(static_cast<float>(pose.x));
  y_m.push_back(static_cast<float>(pose.y));
  cosine.push_back(static_cast<float>(std::cos(pose.phi)));
  sine.push_back(static_cast<float>(std::sin(pose.phi)));
  distance_m.push_back(static_cast<float>(drivenSoFar_m));
}

RolloutOutcome rollOut(const mrpt::math::TTwist2D& twist, const RolloutSetup& setup,
                       const CostGrid& costs, const FootprintCover& footprint) {
  return runWhatIsNeeded(ArcStepper(twist, setup, costs), setup, costs, footprint);
}

RolloutOutcome rollOut(const SampledPath& path, double reach_m, const RolloutSetup& setup,
                       const CostGrid& costs, const FootprintCover& footprint) {
  return runWhatIsNeeded(PathStepper(path, reach_m, setup, costs), setup, costs, footprint);
}

std::vector<mrpt::math::TPose2D> rolloutPoses(const mrpt::math::TTwist2D& twist,
                                              const RolloutSetup& setup, int steps,
                                              const CostGrid& costs) {
  ArcStepper arc(twist, setup, costs);
  std::vector<mrpt::math::TPose2D> poses{setup.start};
  for (int i = 0; i < std::min(steps, arc.steps); ++i) {
    arc.advance();
    arc.turnChord();
    arc.turnHeading();
    poses.emplace_back(
        costs.getXMin() + static_cast<double>(arc.x) * costs.getResolution(),
        costs.getYMin() + static_cast<double>(arc.y) * costs.getResolution(),
        std::atan2(static_cast<double>(arc.headingSin), static_cast<double>(arc.headingCos)));
  }
  return poses;
}

}  // namespace bslnav
