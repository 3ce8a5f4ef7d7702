#include <bslnav/planning/CandidateEvaluator.h>

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

bool isAdmissible(const Candidate& candidate) {
  return candidate.verdict == Candidate::Verdict::Admissible;
}

/** Ties go to the faster, then to the straighter candidate, so that equal costs never leave the
 * robot standing. */
auto rank(const Candidate& c) {
  return std::make_tuple(-c.speed_mps(), std::abs(c.w_radps), std::abs(c.vy_mps), c.total);
}

/** How much a candidate differs from a velocity, and how far from straight ahead it drives [m²/s²].
 */
double unrest(const Candidate& c, const mrpt::math::TTwist2D& from) {
  const double x = c.v_mps - from.vx, y = c.vy_mps - from.vy;
  const double w = kLever_m * (c.w_radps - from.omega);
  return x * x + y * y + w * w + c.vy_mps * c.vy_mps;
}

}  // namespace

double speedCap(const DwaInput& input, const RobotLimits& limits, double controlPeriod_s) {
  const double most_mps = std::min(limits.maxSpeed_mps, input.maxSpeed_mps);
  if (input.goalTolerance_m <= 0.0 || !input.stopsAtGoal) return most_mps;
  const mrpt::math::TPoint2D robot{input.mapFromRobot.x, input.mapFromRobot.y};
  return std::min(most_mps, stoppingSpeed((input.goal - robot).norm(), limits.deceleration_mps2,
                                          controlPeriod_s));
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
  twist_ = input.twist;
  costs_ = &costs;
  guard_ = input.guard;
  movers_ = input.movers;
}

void CandidateEvaluator::evaluate(Candidate& candidate) const {
  if (mayDrive(candidate))
    judge(candidate, rollOut(candidate.twist(), setup_, *costs_, footprint_));
}

void CandidateEvaluator::evaluate(Candidate& candidate, const SampledPath& path,
                                  double reach_m) const {
  if (mayDrive(candidate)) judge(candidate, rollOut(path, reach_m, setup_, *costs_, footprint_));
}

/** Whether it neither turns back on the spot nor is refused by the guard; says so in the candidate
 * otherwise. */
bool CandidateEvaluator::mayDrive(Candidate& candidate) const {
  candidate.terms = {};
  candidate.total = 0.0;
  candidate.steps = 0;
  const bool turnsBack = !oscillation_.allows(candidate.speed_mps(), candidate.w_radps);
  if (turnsBack)
    candidate.verdict = Candidate::Verdict::Oscillation;
  else if (guard_ && !guard_->admitsTowards(candidate.twist(), twist_))
    candidate.verdict = Candidate::Verdict::Guarded;
  else
    return true;
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
  const double speed_mps = candidate.speed_mps();
  candidate.terms = {pathDistance_(rollout.endPoint), goalTerm(rollout, speed_mps, setup_),
                     dangerTerm(rollout.highestCost, unavoidable, parameters_.weights),
                     velocityTerm(speed_mps, parameters_.weights),
                     movers_ ? movers_->cost(candidate.twist()) : 0.0};
  candidate.total = weighted(candidate.terms, parameters_.weights);
}

/** Of the candidates that lead the same way as the best one, and as fast, the calmest. */
const Candidate& CandidateEvaluator::calmest(const std::vector<Candidate>& candidates,
                                             const Candidate& best) const {
  const Candidate* chosen = &best;
  double least = unrest(best, twist_);
  for (const Candidate& c : candidates) {
    const bool same = isAdmissible(c) && c.total <= best.total + kSameWay &&
                      c.speed_mps() >= 0.95 * best.speed_mps();
    if (!same || unrest(c, twist_) >= least) continue;
    least = unrest(c, twist_);
    chosen = &c;
  }
  return *chosen;
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
  const bool lateral = limits_.maxLateralSpeed_mps > 0.0 && parameters_.lateralSamples > 1;
  if (best && lateral) best = &calmest(result.candidates, *best);
  result.setup = setup_;
  result.status = best ? DwaResult::Status::Ok : DwaResult::Status::NoAdmissible;
  result.best = best ? static_cast<int>(best - result.candidates.data()) : -1;
  if (best) oscillation_.commanded(best->speed_mps(), best->w_radps, setup_.start);
}

}  // namespace bslnav
