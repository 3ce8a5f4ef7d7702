#include <bslnav/planning/CandidateEvaluator.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace bslnav {
namespace {

// Costs this near to each other are equal: a tenth of a millimetre of the way, far above rounding.
constexpr double kTie = 1e-4;

bool isAdmissible(const Candidate& candidate) {
  return candidate.verdict == Candidate::Verdict::Admissible;
}

/** Ties go to the faster, then to the straighter candidate, so that equal costs never leave the
 * robot standing. */
auto rank(const Candidate& c) { return std::make_tuple(-c.v_mps, std::abs(c.w_radps), c.total); }

}  // namespace

double speedCap(const DwaInput& input, const RobotLimits& limits, double controlPeriod_s) {
  if (input.goalTolerance_m <= 0.0 || !input.stopsAtGoal) return limits.maxSpeed_mps;
  const mrpt::math::TPoint2D robot{input.mapFromRobot.x, input.mapFromRobot.y};
  return stoppingSpeed((input.goal - robot).norm(), limits.deceleration_mps2, controlPeriod_s);
}

CandidateEvaluator::CandidateEvaluator(const DwaParameters& parameters, const RobotLimits& limits,
                                       const FootprintCover& footprint)
    : parameters_(parameters),
      limits_(limits),
      footprint_(footprint),
      oscillation_(parameters.oscillation) {}

void CandidateEvaluator::begin(const DwaInput& input, const CostGrid& costs) {
  const mrpt::math::TPoint2D robot{input.mapFromRobot.x, input.mapFromRobot.y};
  const double reach = limits_.maxSpeed_mps * parameters_.horizon_s;
  pathDistance_.setPath(input.path, robot, 0.5 * reach, 1.5 * reach, 2.0 * costs.getResolution());
  setup_ = {input.mapFromRobot,       parameters_.horizon_s, parameters_.step_s,
            parameters_.allowUnknown, footprint_.reach_m(),  input.goal,
            input.goalTolerance_m};
  const Cost goalCost = costs.costAt(input.goal.x, input.goal.y);
  goalCost_ = goalCost <= kHighestGradedCost ? goalCost : kFreeCost;
  costs_ = &costs;
}

void CandidateEvaluator::evaluate(Candidate& candidate) const {
  if (mayTurn(candidate))
    judge(candidate, rollOut(candidate.v_mps, candidate.w_radps, setup_, *costs_, footprint_));
}

void CandidateEvaluator::evaluate(Candidate& candidate, const SampledPath& path,
                                  double reach_m) const {
  if (mayTurn(candidate)) judge(candidate, rollOut(path, reach_m, setup_, *costs_, footprint_));
}

/** Whether it does not turn back on the spot; says so in the candidate if it does. */
bool CandidateEvaluator::mayTurn(Candidate& candidate) const {
  candidate.terms = {};
  candidate.total = 0.0;
  candidate.steps = 0;
  if (oscillation_.allows(candidate.v_mps, candidate.w_radps)) return true;
  candidate.verdict = Candidate::Verdict::Oscillation;
  return false;
}

void CandidateEvaluator::judge(Candidate& candidate, const RolloutOutcome& rollout) const {
  using Verdict = Candidate::Verdict;
  using End = RolloutOutcome::End;
  candidate.steps = rollout.steps;
  if (rollout.blocked()) {
    candidate.verdict = rollout.end == End::Unknown ? Verdict::Unknown : Verdict::Obstacle;
    return;
  }
  candidate.verdict = Verdict::Admissible;
  const Cost unavoidable = rollout.end == End::Goal ? goalCost_ : kFreeCost;
  candidate.terms = {pathDistance_(rollout.endPoint), goalTerm(rollout, candidate.v_mps, setup_),
                     dangerTerm(rollout.highestCost, unavoidable, parameters_.weights),
                     velocityTerm(candidate.v_mps, parameters_.weights)};
  candidate.total = weighted(candidate.terms, parameters_.weights);
}

void CandidateEvaluator::choose(DwaResult& result) {
  double cheapest = std::numeric_limits<double>::max();
  for (const Candidate& candidate : result.candidates)
    if (isAdmissible(candidate)) cheapest = std::min(cheapest, candidate.total);
  const Candidate* best = nullptr;
  for (const Candidate& candidate : result.candidates) {
    if (!isAdmissible(candidate) || candidate.total > cheapest + kTie) continue;
    if (!best || rank(candidate) < rank(*best)) best = &candidate;
  }
  result.setup = setup_;
  result.status = best ? DwaResult::Status::Ok : DwaResult::Status::NoAdmissible;
  result.best = best ? static_cast<int>(best - result.candidates.data()) : -1;
  if (best) oscillation_.commanded(best->v_mps, best->w_radps, setup_.start);
}

}  // namespace bslnav
