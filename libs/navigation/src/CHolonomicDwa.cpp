#include <bslnav/config/Config.h>
#include <bslnav/config/Error.h>
#include <bslnav/navigation/CHolonomicDwa.h>
#include <bslnav/planning/DynamicWindow.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/nav/tpspace/CParameterizedTrajectoryGenerator.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cmath>

#include "CHolonomicDwaLog.h"
#include "PtgPaths.h"

namespace bslnav {
namespace {

/** The part of a path's full speed that lies within a window: scales low to high; empty if low is
 * above high. */
struct Scales {
  double low = 0.0, high = 1.0;

  void keepWithin(double full, double least, double most) {
    if (full < 0.0) {
      std::swap(least, most);
    }
    if (std::abs(full) < 1e-9) {
      if (least > 1e-9 || most < -1e-9) high = -1.0;  // the window has no zero
      return;
    }
    low = std::max(low, least / full);
    high = std::min(high, most / full);
  }
};

/** The sections of MRPT's INI file that describe the method, bound to its parameters. */
void bindTo(Config& config, DwaParameters& dwa, RobotLimits& limits) {
  config.bind("dwa", "Dynamic window approach with the paper's cost function.", dwa);
  config.bind("limits", "What the robot's base can do.", limits);
}

}  // namespace

IMPLEMENTS_SERIALIZABLE(CHolonomicDwa, CAbstractHolonomicReactiveMethod, bslnav)

CHolonomicDwa::CHolonomicDwa()
    : mrpt::nav::CAbstractHolonomicReactiveMethod("bslnav::CHolonomicDwa") {}

uint8_t CHolonomicDwa::serializeGetVersion() const { return 0; }
void CHolonomicDwa::serializeTo(mrpt::serialization::CArchive&) const {}  // it has no state
void CHolonomicDwa::serializeFrom(mrpt::serialization::CArchive&, uint8_t) {}

void CHolonomicDwa::use(const DwaParameters& parameters, const RobotLimits& limits,
                        double controlPeriod_s, std::shared_ptr<CandidateEvaluator> evaluator) {
  parameters_ = parameters;
  limits_ = limits;
  controlPeriod_s_ = controlPeriod_s;
  evaluator_ = std::move(evaluator);
}

void CHolonomicDwa::initialize(const mrpt::config::CConfigFileBase& file) {
  Config config;
  bindTo(config, parameters_, limits_);
  config.loadOwnSections(file, "MRPT's configuration");
  // MRPT's engine has tested the robot's shape already: a point is enough on open ground.
  const InflationLayer none({0.05, 10.0}, 0.0, openGround_.getResolution());
  evaluator_ = std::make_shared<CandidateEvaluator>(
      parameters_, limits_, FootprintCover({}, openGround_.getResolution(), none));
}

void CHolonomicDwa::saveConfigFile(mrpt::config::CConfigFileBase& file) const {
  DwaParameters dwa = parameters_;
  RobotLimits limits = limits_;
  Config config;
  bindTo(config, dwa, limits);
  config.copyTo(file);
}

void CHolonomicDwa::navigate(const NavInput& ni, NavOutput& no) {
  const auto* ptg = getAssociatedPTG();
  if (!ptg || !evaluator_)
    throw Error("bslnav::CHolonomicDwa", "has no PTG, or was not initialised", Error::Kind::Run);
  if (situation_) {
    evaluator_->begin(situation_->input, *situation_->costs);
    evaluatePaths(situation_->input, nullptr);
  } else {
    const auto& state = ptg->getCurrentNavDynamicState();
    makeOpenGround();
    const std::vector<mrpt::math::TPoint2D> noPath;  // the target is all that MRPT knows
    const DwaInput input{
        {}, state.curVelLocal, noPath, {state.relTarget.x, state.relTarget.y}, 0.1, true};
    evaluator_->begin(input, openGround_);
    evaluatePaths(input, &ni);
  }
  evaluator_->choose(result_);
  result_.command =
      limited(result_.chosenVelocity(),
              situation_ ? situation_->input.twist : ptg->getCurrentNavDynamicState().curVelLocal,
              limits_, controlPeriod_s_);
  no.logRecord = scoresOf(result_, parameters_.speedSamples);
  if (result_.best < 0) {
    no.desiredDirection = no.desiredSpeed = 0.0;
    return;
  }
  const auto k = static_cast<std::uint16_t>(result_.best / parameters_.speedSamples);
  const auto full = commandOf(*ptg->directionToMotionCommand(k));
  const auto& best = result_.candidates[static_cast<std::size_t>(result_.best)];
  no.desiredDirection = ptg->index2alpha(k);
  const bool turns = full.vx == 0.0 && full.vy == 0.0;
  const double part = turns ? best.w_radps / full.omega
                            : std::hypot(best.v_mps, best.vy_mps) / std::hypot(full.vx, full.vy);
  no.desiredSpeed = ni.maxRobotSpeed * std::abs(part);
}

/** Free cells as far as a rollout reaches. */
void CHolonomicDwa::makeOpenGround() {
  const double reach_m = limits_.maxSpeed_mps * parameters_.horizon_s + 1.0;
  const double cell_m = openGround_.getResolution();
  const int cells = static_cast<int>(2.0 * reach_m / cell_m);
  if (openGround_.width() != cells)
    openGround_ = CostGrid(cells, cells, cell_m, -reach_m, -reach_m);
}

/** What MRPT knows of obstacles near a candidate: how much of the path's free distance it leaves,
 * and, with evaluate_clearance in MRPT's configuration, how near to obstacles the path leads. The
 * danger decays with both, as costs around obstacles do, so that the robot turns away in time. */
void CHolonomicDwa::heed(const NavInput& ni, std::uint16_t k, double reach_m,
                         Candidate& candidate) const {
  constexpr double kDecay_m = 0.25;
  const double reference_m = getAssociatedPTG()->getRefDistance();
  double gap_m = ni.obstacles[k] * reference_m - reach_m;
  if (gap_m < 0.0) candidate.verdict = Candidate::Verdict::Obstacle;
  if (candidate.verdict != Candidate::Verdict::Admissible) return;
  if (ni.clearance && !ni.clearance->empty())
    gap_m =
        std::min(gap_m, reference_m * ni.clearance->getClearance(k, reach_m / reference_m, false));
  const auto cost = static_cast<Cost>(kHighestGradedCost * std::exp(-gap_m / kDecay_m));
  candidate.terms.danger = dangerTerm(cost, kFreeCost, parameters_.weights);
  candidate.total = weighted(candidate.terms, parameters_.weights);
}

void CHolonomicDwa::evaluatePaths(const DwaInput& input, const NavInput* stock) {
  const auto& ptg = *getAssociatedPTG();
  const int speeds = parameters_.speedSamples;
  const double cap = speedCap(input, limits_, controlPeriod_s_);
  const DynamicWindow window = dynamicWindow(input.twist, limits_, parameters_.window_s, cap);
  const double spacing = situation_ ? situation_->costs->getResolution() : 0.05;
  result_.candidates.resize(static_cast<std::size_t>(ptg.getPathCount() * speeds));
  auto candidate = result_.candidates.begin();
  for (std::uint16_t k = 0; k < ptg.getPathCount(); ++k) {
    const auto full = commandOf(*ptg.directionToMotionCommand(k));
    Scales scales;
    if (full == mrpt::math::TTwist2D()) scales.high = -1.0;  // leads nowhere
    scales.keepWithin(full.vx, window.vMin, window.vMax);
    scales.keepWithin(full.vy, window.vyMin, window.vyMax);
    scales.keepWithin(full.omega, window.wMin, window.wMax);
    if (scales.low > scales.high) {
      for (int i = 0; i < speeds; ++i, ++candidate) {
        *candidate = {};
        candidate->verdict = Candidate::Verdict::OutOfWindow;
      }
      continue;
    }
    const double horizon_m = std::hypot(full.vx, full.vy) * scales.high * parameters_.horizon_s;
    samplePath(ptg, k, horizon_m, spacing, path_);
    for (int i = speeds - 1; i >= 0; --i, ++candidate) {
      const double scale = sampleOf(scales.low, scales.high, i, speeds);
      candidate->v_mps = full.vx * scale;
      candidate->vy_mps = full.vy * scale;
      candidate->w_radps = full.omega * scale;
      const double reach = std::hypot(full.vx, full.vy) * scale * parameters_.horizon_s;
      evaluator_->evaluate(*candidate, path_, reach);
      if (stock) heed(*stock, k, reach, *candidate);
    }
  }
}

}  // namespace bslnav
