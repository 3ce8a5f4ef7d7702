#include <bslnav/planning/DwaPlanner.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace bslnav {

namespace {

// Costs this near to each other are equal: a tenth of a millimetre of the way, far above rounding.
constexpr double kTie = 1e-4;
// Lateral motion gives many velocities for one way: costs this near are those of the same way, a
// centimetre aside, but for the sampling.
constexpr double kSameWay = 0.02;
constexpr double kLever_m = 0.3;  // by which turning counts beside driving

/** How much a candidate differs from a velocity, and how far from straight ahead it drives [m²/s²].
 */
double unrest(const Candidate& c, const mrpt::math::TTwist2D& from) {
  const double x = c.v_mps - from.vx, y = c.vy_mps - from.vy,
               w = kLever_m * (c.w_radps - from.omega);
  return x * x + y * y + w * w + c.vy_mps * c.vy_mps;
}

/** Of the candidates that lead the same way as the best one and as fast, the calmest. */
int calmest(const DwaResult& result, const mrpt::math::TTwist2D& from) {
  const Candidate& best = result.candidates[static_cast<std::size_t>(result.best)];
  int chosen = result.best;
  double least = unrest(best, from);
  for (std::size_t i = 0; i < result.candidates.size(); ++i) {
    const Candidate& c = result.candidates[i];
    if (c.verdict != Candidate::Verdict::Admissible || c.total > best.total + kSameWay ||
        c.speed_mps() < 0.95 * best.speed_mps() || unrest(c, from) >= least)
      continue;
    least = unrest(c, from);
    chosen = static_cast<int>(i);
  }
  return chosen;
}

}  // namespace

void CostWeights::describe(ConfigSection& section) {
  section.number("weight_path", path, kNonNegative, "1/m",
                 "W_pos: weight of the distance to the global path");
  section.number("weight_goal", goal, kNonNegative, "1/m",
                 "W_gol: weight of the distance to the local goal");
  section.number("weight_danger", danger, kNonNegative, "",
                 "W_dan: weight of the highest cost along the rollout");
  section.number("weight_velocity", velocity, kNonNegative, "m/s",
                 "W_vel: weight of 1/v; the paper's is 0.5");
  section.number("danger_divisor", dangerDivisor, {1.0, 255.0}, "",
                 "c_dan is the highest cost divided by this");
  section.number("speed_floor_mps", speedFloor_mps, {0.001, 10.0}, "m/s",
                 "c_vel = 1/max(v, floor)");
}

void DwaParameters::describe(ConfigSection& section) {
  section.number("horizon_s", horizon_s, {0.1, 30.0}, "s",
                 "T_pre: how far ahead a candidate is driven");
  section.number("step_s", step_s, {0.01, 1.0}, "s",
                 "longest time step of a rollout; never passes over a cell");
  section.number("window_s", window_s, {0.01, 10.0}, "s",
                 "velocities that can be reached within this time are candidates");
  section.integer("speed_samples", speedSamples, {2, 500}, "", "speeds in the dynamic window");
  section.integer("yaw_rate_samples", yawRateSamples, {1, 500}, "",
                  "turning rates in the dynamic window");
  section.integer("lateral_samples", lateralSamples, {1, 500}, "",
                  "lateral speeds in the dynamic window, when the robot can move sideways");
  section.flag("allow_unknown", allowUnknown,
               "whether a rollout may cross unknown cells and leave the map");
  weights.describe(section);
  oscillation.describe(section);
}

DwaPlanner::DwaPlanner(const DwaParameters& parameters, const RobotLimits& limits,
                       const FootprintCover& footprint, double controlPeriod_s)
    : parameters_(parameters),
      limits_(limits),
      footprint_(footprint),
      controlPeriod_s_(controlPeriod_s),
      oscillation_(parameters.oscillation) {
  if (limits.maxLateralSpeed_mps == 0.0) parameters_.lateralSamples = 1;
  const int count =
      parameters.speedSamples * parameters_.lateralSamples * parameters.yawRateSamples;
  result_.candidates.resize(static_cast<std::size_t>(count));
}

const DwaResult& DwaPlanner::plan(const DwaInput& input, const CostGrid& costs) {
  const mrpt::math::TPoint2D robot{input.mapFromRobot.x, input.mapFromRobot.y};
  const double reach = limits_.maxSpeed_mps * parameters_.horizon_s;
  pathDistance_.setPath(input.path, robot, 0.5 * reach, 1.5 * reach, 2.0 * costs.getResolution());
  result_.setup = {input.mapFromRobot,       parameters_.horizon_s, parameters_.step_s,
                   parameters_.allowUnknown, footprint_.reach_m(),  input.goal,
                   input.goalTolerance_m};
  // Rollouts need not overshoot the goal, and the robot does not creep towards it.
  const Cost goalCost = costs.costAt(input.goal.x, input.goal.y);
  goalCost_ = goalCost <= kHighestGradedCost ? goalCost : kFreeCost;
  double cap = limits_.maxSpeed_mps;
  if (input.goalTolerance_m > 0.0 && input.stopsAtGoal)
    cap = stoppingSpeed((input.goal - robot).norm(), limits_.deceleration_mps2, controlPeriod_s_);
  const DynamicWindow window = dynamicWindow(input.twist, limits_, parameters_.window_s, cap);

  sample(window, input.twist, cap);
  for (Candidate& candidate : result_.candidates) evaluate(candidate, costs);
  choose(input);
  return result_;
}

void DwaPlanner::sample(const DynamicWindow& window, const mrpt::math::TTwist2D& current,
                        double speedCap_mps) {
  const int speeds = parameters_.speedSamples, sides = parameters_.lateralSamples;
  const int turns = parameters_.yawRateSamples;
  auto candidate = result_.candidates.begin();
  for (int i = speeds - 1; i >= 0; --i)
    for (int j = 0; j < sides; ++j)
      for (int k = 0; k < turns; ++k, ++candidate) {
        const auto twist = withinWindow({sampleOf(window.vMin, window.vMax, i, speeds),
                                         sampleOf(window.vyMin, window.vyMax, j, sides),
                                         sampleOf(window.wMin, window.wMax, k, turns)},
                                        current, limits_, parameters_.window_s, speedCap_mps);
        candidate->v_mps = twist.vx;
        candidate->vy_mps = twist.vy;
        candidate->w_radps = twist.omega;
      }
}

void DwaPlanner::evaluate(Candidate& candidate, const CostGrid& costs) const {
  using Verdict = Candidate::Verdict;
  candidate.terms = {};
  candidate.total = 0.0;
  candidate.steps = 0;
  const double speed_mps = candidate.speed_mps();
  if (!oscillation_.allows(speed_mps, candidate.w_radps)) {
    candidate.verdict = Verdict::Oscillation;
    return;
  }
  const RolloutOutcome rollout = rollOut(candidate.twist(), result_.setup, costs, footprint_);
  candidate.steps = rollout.steps;
  if (rollout.blocked()) {
    candidate.verdict =
        rollout.end == RolloutOutcome::End::Unknown ? Verdict::Unknown : Verdict::Obstacle;
    return;
  }
  candidate.verdict = Verdict::Admissible;
  const Cost unavoidable = rollout.end == RolloutOutcome::End::Goal ? goalCost_ : kFreeCost;
  candidate.terms = {pathDistance_(rollout.endPoint), goalTerm(rollout, speed_mps, result_.setup),
                     dangerTerm(rollout.highestCost, unavoidable, parameters_.weights),
                     velocityTerm(speed_mps, parameters_.weights)};
  candidate.total = weighted(candidate.terms, parameters_.weights);
}

void DwaPlanner::choose(const DwaInput& input) {
  const auto admissible = [](const Candidate& c) {
    return c.verdict == Candidate::Verdict::Admissible;
  };
  double cheapest = std::numeric_limits<double>::max();
  for (const Candidate& candidate : result_.candidates)
    if (admissible(candidate)) cheapest = std::min(cheapest, candidate.total);
  // Ties go to the faster, then to the straighter candidate, so that equal costs never leave the
  // robot standing.
  const auto rank = [](const Candidate& c) {
    return std::make_tuple(-c.speed_mps(), std::abs(c.w_radps), std::abs(c.vy_mps), c.total);
  };
  result_.best = -1;
  for (std::size_t i = 0; i < result_.candidates.size(); ++i) {
    const Candidate& candidate = result_.candidates[i];
    if (!admissible(candidate) || candidate.total > cheapest + kTie) continue;
    if (result_.best < 0 ||
        rank(candidate) < rank(result_.candidates[static_cast<std::size_t>(result_.best)]))
      result_.best = static_cast<int>(i);
  }
  if (result_.best < 0) {
    result_.status = DwaResult::Status::NoAdmissible;
    result_.command = brake(input.twist, limits_, controlPeriod_s_);
    return;
  }
  if (parameters_.lateralSamples > 1) result_.best = calmest(result_, input.twist);
  const Candidate& best = result_.candidates[static_cast<std::size_t>(result_.best)];
  result_.status = DwaResult::Status::Ok;
  result_.command = limited(best.twist(), input.twist, limits_, controlPeriod_s_);
  oscillation_.commanded(best.speed_mps(), best.w_radps, input.mapFromRobot);
}

}  // namespace bslnav
