#include <bslnav/planning/CandidateEvaluator.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "../support/NeighbourCosts.h"
#include "DwaGenerators.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using test::any;
using Verdict = Candidate::Verdict;

constexpr double kCell_m = 0.05;

CandidateEvaluator evaluator() {
  return CandidateEvaluator({}, {}, FootprintCover({}, kCell_m, test::noInflation()));
}

/** The arc of a velocity, sampled as a path. */
SampledPath arc(double v, double w, double horizon_s) {
  SampledPath path;
  const int pieces = static_cast<int>(std::ceil(v * horizon_s / (0.9 * kCell_m))) + 1;
  for (int i = 0; i <= pieces; ++i) {
    const double t = horizon_s * i / pieces;
    path.add(test::onArc({}, v, w, t), v * t);
  }
  return path;
}

Candidate judged(const CandidateEvaluator& evaluator, double v, double w, const SampledPath* path,
                 double reach_m) {
  Candidate candidate;
  candidate.v_mps = v;
  candidate.w_radps = w;
  if (path)
    evaluator.evaluate(candidate, *path, reach_m);
  else
    evaluator.evaluate(candidate);
  return candidate;
}

/** Where both pass the same cells they must cost the same. A path is sampled at other points than
 * the arc is stepped, so a cell at its edge may be met by one and not by the other: the path's
 * verdict and danger lie between those over the lowest and the highest costs next to each cell. */
RC_GTEST_PROP(CandidateEvaluatorLaw, APathCostsWhatTheSameArcCosts, ()) {
  const CostGrid grid =
      test::inflated(test::scattered(12), InflationLayer({0.4, 5.0}, 0.12, kCell_m));
  const CostGrid below = test::lowestNeighbour(grid), above = test::highestNeighbour(grid);
  const std::vector<TPoint2D> way = test::straightPath(2.5);
  const DwaInput input{{any(-0.5, 0.5), any(-0.5, 0.5), any(-M_PI, M_PI)}, {}, way, way.back()};
  const double v = any(0.1, 0.55), w = any(-1.0, 1.0), part = any(0.2, 1.0);
  const double horizon_s = DwaParameters().horizon_s;
  const SampledPath path = arc(v / part, w / part, horizon_s);

  CandidateEvaluator at = evaluator();
  at.begin(input, grid);
  const Candidate ofPath = judged(at, v, w, &path, v * horizon_s);
  at.begin(input, below);
  const Candidate least = judged(at, v, w, nullptr, 0.0);
  at.begin(input, above);
  const Candidate most = judged(at, v, w, nullptr, 0.0);

  const bool blocked = ofPath.verdict == Verdict::Obstacle;
  RC_TAG(blocked ? "blocked" : "free");
  if (least.verdict == Verdict::Obstacle) RC_ASSERT(blocked);
  if (blocked) RC_ASSERT(most.verdict == Verdict::Obstacle);
  if (blocked || ofPath.verdict == Verdict::Unknown) return;
  RC_ASSERT(ofPath.terms.velocity == least.terms.velocity);
  RC_ASSERT(least.terms.danger <= ofPath.terms.danger);
  if (least.verdict == Verdict::Admissible) {
    RC_ASSERT(std::abs(ofPath.terms.path - least.terms.path) < 5e-3);
    RC_ASSERT(std::abs(ofPath.terms.goal - least.terms.goal) < 5e-3);
  }
  if (most.verdict == Verdict::Admissible) RC_ASSERT(ofPath.terms.danger <= most.terms.danger);
}

TEST(CandidateEvaluator, APathIsCutWhereTheCandidateDoesNotReach) {
  const CostGrid grid = test::wallFrom(1.0, kLethalCost);
  const std::vector<TPoint2D> way = test::straightPath(3.0);
  const DwaInput input{{}, {}, way, way.back()};
  CandidateEvaluator at = evaluator();
  at.begin(input, grid);
  const SampledPath straight = arc(1.0, 0.0, 4.0);
  EXPECT_EQ(judged(at, 0.2, 0.0, &straight, 0.8).verdict, Verdict::Admissible);
  EXPECT_NEAR(judged(at, 0.2, 0.0, &straight, 0.83).terms.goal, 3.0 - 0.83, 1e-5);
  EXPECT_EQ(judged(at, 0.3, 0.0, &straight, 1.2).verdict, Verdict::Obstacle);
}

TEST(CandidateEvaluator, APathThatPassesTheGoalEndsThere) {
  const CostGrid grid = test::freeSpace();
  const std::vector<TPoint2D> way = test::straightPath(1.0);
  CandidateEvaluator at = evaluator();
  at.begin({{}, {}, way, way.back(), 0.1, true}, grid);
  const SampledPath straight = arc(0.5, 0.0, 4.0);
  // as for a velocity: what is left of the rollout counts below zero, 1 m - 0.5 m/s * 4 s
  EXPECT_NEAR(judged(at, 0.5, 0.0, &straight, 2.0).terms.goal, -1.0, 1e-6);
  EXPECT_NEAR(judged(at, 0.5, 0.0, nullptr, 2.0).terms.goal, -1.0, 1e-6);
}

TEST(CandidateEvaluator, AFootprintWithCornersIsTestedAlongAPath) {
  CostGrid grid = test::freeSpace();
  for (int x = grid.cellX(0.9); x <= grid.cellX(1.1); ++x)
    grid.at(x, grid.cellY(0.35)) = kLethalCost;
  const std::vector<TPoint2D> way = test::straightPath(3.0);
  const FootprintCover wide(test::rectangle(0.4, 0.8), kCell_m, test::noInflation());
  CandidateEvaluator at({}, {}, wide);
  at.begin({{}, {}, way, way.back()}, grid);
  const SampledPath straight = arc(0.5, 0.0, 4.0);
  EXPECT_EQ(judged(at, 0.5, 0.0, &straight, 2.0).verdict, Verdict::Obstacle);
  EXPECT_EQ(judged(at, 0.1, 0.0, &straight, 0.4).verdict, Verdict::Admissible);
}

}  // namespace
}  // namespace bslnav
