#include <bslnav/planning/DwaPlanner.h>
#include <gtest/gtest.h>

#include "../support/HeapUse.h"
#include "DwaGenerators.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;
using mrpt::math::TTwist2D;
using test::freeSpace;
using test::wallFrom;
using Verdict = Candidate::Verdict;
using Status = DwaResult::Status;

constexpr double kPeriod_s = 0.1;
constexpr RobotLimits kLimits{};

FootprintCover circle() { return FootprintCover({}, 0.05, test::noInflation()); }
/** Candidates are what one control period can reach, so that numbers are easily followed. */
DwaParameters onePeriod() {
  DwaParameters parameters;
  parameters.window_s = kPeriod_s;
  return parameters;
}
DwaPlanner planner(const DwaParameters& parameters = onePeriod()) {
  return DwaPlanner(parameters, kLimits, circle(), kPeriod_s);
}
TEST(DwaPlanner, ChoosesTheFastestStraightCandidateInTheFree) {
  const auto path = test::straightPath(5.0);
  auto dwa = planner();
  const DwaResult& result = dwa.plan({{}, {0.4, 0.0, 0.0}, path, {3.0, 0.0}}, freeSpace());
  EXPECT_EQ(result.status, Status::Ok);
  EXPECT_DOUBLE_EQ(result.command.vx, 0.45);  // 0.4 + 0.5·0.1
  EXPECT_EQ(result.command.omega, 0.0);
}

TEST(DwaPlanner, KeepsToTheSpeedThatIsWanted) {
  const auto path = test::straightPath(5.0);
  auto dwa = planner();
  DwaInput input{{}, {0.3, 0.0, 0.0}, path, {3.0, 0.0}};
  input.maxSpeed_mps = 0.32;
  EXPECT_NEAR(dwa.plan(input, freeSpace()).command.vx, 0.32, 1e-9);
  input.maxSpeed_mps = 0.2;  // as soon as it can
  EXPECT_NEAR(dwa.plan(input, freeSpace()).command.vx, 0.25, 1e-9);
}

TEST(DwaPlanner, AnswersTiesByTheFastestStraightCandidate) {
  DwaParameters parameters = onePeriod();
  parameters.weights.path = parameters.weights.goal = parameters.weights.danger = 0.0;
  auto dwa = planner(parameters);
  const DwaResult& result = dwa.plan({{}, {}, test::straightPath(5.0), {3.0, 0.0}}, freeSpace());
  EXPECT_DOUBLE_EQ(result.command.vx, 0.05);
  EXPECT_EQ(result.command.omega, 0.0);
}

TEST(DwaPlanner, RecordsTermsOfEveryCandidateAndTheirWeightedSum) {
  DwaParameters parameters = onePeriod();
  parameters.weights = {2.0, 3.0, 5.0, 0.5, 0.0, 253.0, 0.1};
  auto dwa = planner(parameters);
  const auto path = test::straightPath(5.0);
  CostGrid grid = wallFrom(0.5, 100);
  const DwaResult& result = dwa.plan({{}, {0.2, 0.0, 0.0}, path, {3.0, 0.0}}, grid);
  ASSERT_EQ(result.candidates.size(), 800u);
  for (const Candidate& candidate : result.candidates) {
    ASSERT_EQ(candidate.verdict, Verdict::Admissible);
    const auto end = rollOut(candidate.v_mps, candidate.w_radps, result.setup, grid, circle());
    ASSERT_NEAR(candidate.terms.path, std::hypot(std::min(end.endPoint.x, 0.0), end.endPoint.y),
                1e-5);
    ASSERT_NEAR(candidate.terms.goal, (end.endPoint - TPoint2D{3.0, 0.0}).norm(), 1e-9);
    ASSERT_DOUBLE_EQ(candidate.terms.danger, end.highestCost / 253.0);
    ASSERT_DOUBLE_EQ(candidate.terms.velocity, 1.0 / std::max(candidate.v_mps, 0.1));
    const CostTerms& c = candidate.terms;
    ASSERT_NEAR(candidate.total, 2 * c.path + 3 * c.goal + 5 * c.danger + 0.5 * c.velocity, 1e-12);
    ASSERT_GE(candidate.total,
              result.candidates[static_cast<std::size_t>(result.best)].total - 1e-4);
  }
}

TEST(DwaPlanner, SaysWhyCandidatesAreBlocked) {
  CostGrid grid = wallFrom(0.8);
  for (int y = 0; y < grid.height() / 2; ++y)
    for (int x = 0; x < grid.width(); ++x)
      if (grid.at(x, y) == kInscribedCost) grid.at(x, y) = kUnknownCost;
  auto dwa = planner();
  const DwaResult& result =
      dwa.plan({{}, {0.4, 0.0, 0.0}, test::straightPath(5.0), {3.0, 0.0}}, grid);
  for (const Candidate& candidate : result.candidates) {  // 0.35 m/s · 4 s reach x = 0.8
    if (std::abs(candidate.w_radps) > 0.02) {
      ASSERT_EQ(candidate.verdict, candidate.w_radps > 0.0 ? Verdict::Obstacle : Verdict::Unknown);
    }
    ASSERT_EQ(candidate.total, 0.0);
  }
}

TEST(DwaPlanner, CrossesUnknownCellsOnlyWhenAllowed) {
  const CostGrid grid = wallFrom(0.3, kUnknownCost);
  DwaParameters parameters = onePeriod();
  parameters.allowUnknown = true;
  const auto path = test::straightPath(5.0);
  const DwaInput input{{}, {0.5, 0.0, 0.0}, path, {3.0, 0.0}};
  auto strict = planner(), bold = planner(parameters);
  EXPECT_EQ(strict.plan(input, grid).status, Status::NoAdmissible);
  EXPECT_EQ(bold.plan(input, grid).status, Status::Ok);
}

TEST(DwaPlanner, BrakesWithinTheLimitsWhenNothingIsAdmissible) {
  auto dwa = planner();
  const DwaResult& result =
      dwa.plan({{}, {0.5, 0.0, 0.5}, test::straightPath(5.0), {3.0, 0.0}}, wallFrom(0.2));
  EXPECT_EQ(result.status, Status::NoAdmissible);
  EXPECT_EQ(result.best, -1);
  EXPECT_DOUBLE_EQ(result.command.vx, 0.45);    // 0.5 − 0.5·0.1
  EXPECT_DOUBLE_EQ(result.command.omega, 0.3);  // 0.5 − 2·0.1
}

TEST(DwaPlanner, TheVelocityWeightShiftsTheChoiceToFasterCandidates) {
  // Danger rises with x: going slowly stays out of it, 1/v pays for going through.
  CostGrid grid = freeSpace();
  for (int y = 0; y < grid.height(); ++y)
    for (int x = grid.cellX(0.0); x < grid.width(); ++x)
      grid.at(x, y) = static_cast<Cost>(std::min(252, 3 * (x - grid.cellX(0.0))));
  const auto path = test::straightPath(5.0);
  const DwaInput input{{}, {0.3, 0.0, 0.0}, path, {3.0, 0.0}};
  DwaParameters parameters = onePeriod();
  auto slow = planner(parameters);
  parameters.weights.velocity = 0.5;
  auto fast = planner(parameters);
  EXPECT_GT(fast.plan(input, grid).command.vx, slow.plan(input, grid).command.vx + 0.03);
}

TEST(DwaPlanner, CommandsWhatOnePeriodCanDoTowardsACandidateThatTakesLonger) {
  DwaParameters parameters;
  parameters.window_s = 0.6;
  auto dwa = planner(parameters);
  const auto path = test::straightPath(5.0);
  const DwaResult& result = dwa.plan({{}, {0.2, 0.0, 0.0}, path, {3.0, 0.0}}, freeSpace());
  EXPECT_DOUBLE_EQ(result.candidates[static_cast<std::size_t>(result.best)].v_mps, 0.5);
  EXPECT_DOUBLE_EQ(result.command.vx, 0.25);
}

TEST(DwaPlanner, DoesNotTurnBackOnTheSpot) {
  CostGrid grid = wallFrom(-6.0);
  for (int k = 0; k < 9; ++k) grid.at(119 + k % 3, 119 + k / 3) = kFreeCost;  // no room to drive
  const TPose2D pose{0.025, 0.025, 0.0};                                      // in the middle of it
  const auto path = test::straightPath(5.0);
  auto dwa = planner();
  const TTwist2D first = dwa.plan({pose, {0.0, 0.0, 0.5}, path, {3.0, 0.0}}, grid).command;
  ASSERT_LT(first.vx, OscillationParameters{}.slowSpeed_mps);
  ASSERT_GT(first.omega, 0.0);
  int refused = 0;
  for (const Candidate& c : dwa.plan({pose, {}, path, {3.0, 0.0}}, grid).candidates) {
    const bool back = c.v_mps < OscillationParameters{}.slowSpeed_mps && c.w_radps < 0.0;
    ASSERT_EQ(c.verdict == Verdict::Oscillation, back);
    refused += back;
  }
  EXPECT_GT(refused, 0);
}

TEST(DwaPlanner, AllocatesNothingAfterTheFirstCall) {
  const CostGrid grid = wallFrom(2.0, 50);
  const auto path = test::straightPath(5.0);
  const FootprintCover cover(test::rectangle(0.6, 0.5), 0.05, test::noInflation());
  DwaPlanner dwa({}, kLimits, cover, kPeriod_s);
  const DwaInput first{{1.0, 0.0, 0.0}, {0.5, 0.0, 0.0}, path, {4.0, 0.0}, 0.1};
  const DwaInput second{{1.5, 0.1, 0.3}, {0.3, 0.0, 0.2}, path, {4.0, 0.0}, 0.1};
  dwa.plan(first, grid);
  const long before = test::heapUse().allocations;
  for (int i = 0; i < 5; ++i) {
    dwa.plan(second, grid);
    dwa.plan(first, grid);
  }
  EXPECT_EQ(test::heapUse().allocations, before);
  EXPECT_GT(before, 0);  // they are counted
}

}  // namespace
}  // namespace bslnav
