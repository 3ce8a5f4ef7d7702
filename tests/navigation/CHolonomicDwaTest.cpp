#include <bslnav/navigation/CHolonomicDwa.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "../planning/DwaGenerators.h"
#include "../support/NeighbourCosts.h"
#include "PtgRig.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using test::any;
using Method = mrpt::nav::CAbstractHolonomicReactiveMethod;
using Verdict = Candidate::Verdict;

constexpr double kCell_m = 0.05;

class CHolonomicDwaTest : public testing::Test {
 protected:
  CHolonomicDwaTest() {
    dwa.speedSamples = 6;
    evaluator = std::make_shared<CandidateEvaluator>(
        dwa, limits, FootprintCover({}, kCell_m, test::noInflation()));
    method.setAssociatedPTG(ptg.get());
    method.use(dwa, limits, 0.1, evaluator);
  }
  Method::NavOutput navigate(const DwaInput& input, const CostGrid& costs) {
    const DwaSituation situation{input, &costs};
    method.setSituation(&situation);
    Method::NavOutput output;
    method.navigate({}, output);
    return output;
  }

  mrpt::nav::CParameterizedTrajectoryGenerator::Ptr ptg = test::makePtg();
  DwaParameters dwa;
  RobotLimits limits;
  std::shared_ptr<CandidateEvaluator> evaluator;
  CHolonomicDwa method;
};

TEST_F(CHolonomicDwaTest, DrivesStraightAndFastInTheOpen) {
  const auto way = test::straightPath(4.0);
  const auto output = navigate({{}, {0.5, 0.0, 0.0}, way, way.back()}, test::freeSpace());
  EXPECT_NEAR(output.desiredDirection, 0.0, 1e-6);
  EXPECT_NEAR(output.desiredSpeed, 1.0, 0.02);  // the PTG's 0.55 m/s, the limits' 0.556
  EXPECT_EQ(method.result().candidates.size(), 6U * ptg->getPathCount());
}

TEST_F(CHolonomicDwaTest, KeepsItsCandidatesInTheDynamicWindow) {
  const auto way = test::straightPath(4.0);
  dwa.window_s = 0.2;  // with 0.5 m/s² and 2 rad/s² from 0.2 m/s: 0.1 to 0.3 m/s, |w| <= 0.4 rad/s
  method.use(dwa, limits, 0.1, evaluator);
  navigate({{}, {0.2, 0.0, 0.0}, way, way.back()}, test::freeSpace());
  int inside = 0;
  for (const Candidate& c : method.result().candidates) {
    if (c.verdict == Verdict::OutOfWindow) continue;
    ++inside;
    EXPECT_LE(c.v_mps, 0.3 + 1e-9);
    EXPECT_GE(c.v_mps, 0.1 - 1e-9);
    EXPECT_LE(std::abs(c.w_radps), 0.4 + 1e-9);
  }
  EXPECT_GT(inside, 100);
  EXPECT_NEAR(method.result().command.vx, 0.25, 1e-9);  // one period of 0.1 s later
}

TEST_F(CHolonomicDwaTest, StandsWhenEveryPathIsBlocked) {
  const auto way = test::straightPath(4.0);
  CostGrid wall = test::wallFrom(0.05, kLethalCost);
  const auto output = navigate({{}, {0.3, 0.0, 0.0}, way, way.back()}, wall);
  EXPECT_EQ(output.desiredSpeed, 0.0);
  EXPECT_EQ(method.result().status, DwaResult::Status::NoAdmissible);
}

TEST_F(CHolonomicDwaTest, GivesEveryPathAScoreForMrptsOptimizer) {
  const auto way = test::straightPath(4.0);
  const auto output = navigate({{}, {0.5, 0.0, 0.0}, way, way.back()}, test::freeSpace());
  ASSERT_TRUE(output.logRecord);
  const auto& scores = output.logRecord->dirs_eval.back();
  ASSERT_EQ(scores.size(), ptg->getPathCount());
  const auto best = std::max_element(scores.begin(), scores.end()) - scores.begin();
  EXPECT_EQ(best, ptg->alpha2index(output.desiredDirection));
}

TEST_F(CHolonomicDwaTest, WithoutASituationItHeedsMrptsFreeDistances) {
  mrpt::config::CConfigFileMemory ini;
  ini.write("dwa", "speed_samples", 6);
  CHolonomicDwa stock;
  stock.setAssociatedPTG(ptg.get());
  stock.initialize(ini);
  ptg->updateNavDynamicState({{0.3, 0.0, 0.0}, {4.0, 0.0, 0.0}, 0.0});
  Method::NavInput input;
  input.obstacles.assign(ptg->getPathCount(), 1.0);
  Method::NavOutput output;
  stock.navigate(input, output);
  EXPECT_NEAR(output.desiredDirection, 0.0, 1e-6);
  EXPECT_GT(output.desiredSpeed, 0.9);
  for (int k = ptg->getPathCount() / 2 - 3; k <= ptg->getPathCount() / 2 + 3; ++k)
    input.obstacles[static_cast<std::size_t>(k)] = 0.1;  // 0.4 m ahead
  stock.navigate(input, output);
  EXPECT_NE(output.desiredDirection, 0.0);
  EXPECT_GT(output.desiredSpeed, 0.0);
}

TEST_F(CHolonomicDwaTest, RefusesBadParameters) {
  mrpt::config::CConfigFileMemory ini;
  ini.write("dwa", "speed_sample", 6);
  EXPECT_THROW(CHolonomicDwa().initialize(ini), std::exception);
  Method::NavOutput output;
  EXPECT_THROW(CHolonomicDwa().navigate({}, output), std::exception);  // no PTG
}

TEST_F(CHolonomicDwaTest, MrptMakesItByName) {
  mrpt::rtti::registerClass(CLASS_ID(CHolonomicDwa));
  const auto made = Method::Factory("bslnav::CHolonomicDwa");
  ASSERT_TRUE(made);
  EXPECT_NE(dynamic_cast<CHolonomicDwa*>(made.get()), nullptr);
}

/** A candidate of the PTG and the same velocity in the window cost the same, but for cells that
 * only one of the two samplings of the arc meets: so between the costs of the velocity over each
 * cell's lowest and highest neighbour. */
RC_GTEST_FIXTURE_PROP(CHolonomicDwaTest, APtgsCandidateCostsWhatItsVelocityCosts, ()) {
  const CostGrid grid =
      test::inflated(test::scattered(12), InflationLayer({0.4, 5.0}, 0.12, kCell_m));
  const CostGrid below = test::lowestNeighbour(grid), above = test::highestNeighbour(grid);
  const auto way = test::straightPath(2.5);
  const DwaInput input{{any(-0.5, 0.5), any(-0.5, 0.5), any(-M_PI, M_PI)},
                       {any(0.0, 0.55), 0.0, any(-1.0, 1.0)},
                       way,
                       way.back()};
  navigate(input, grid);
  const auto velocitiesOver = [&](const CostGrid& costs) {
    CandidateEvaluator plain(dwa, limits, FootprintCover({}, kCell_m, test::noInflation()));
    plain.begin(input, costs);
    auto candidates = method.result().candidates;
    for (Candidate& candidate : candidates)
      if (candidate.verdict != Verdict::OutOfWindow) plain.evaluate(candidate);
    return candidates;
  };
  const auto least = velocitiesOver(below), most = velocitiesOver(above);
  for (std::size_t i = 0; i < least.size(); ++i) {
    const Candidate& c = method.result().candidates[i];
    if (c.verdict == Verdict::OutOfWindow || c.verdict == Verdict::Unknown) continue;
    if (c.verdict == Verdict::Obstacle) {
      RC_ASSERT(most[i].verdict != Verdict::Admissible);
      continue;
    }
    RC_ASSERT(least[i].verdict == Verdict::Admissible);
    // MRPT integrates its paths in steps and keeps them in a table: a few millimetres
    RC_ASSERT(std::abs(c.terms.path - least[i].terms.path) < 0.02);
    RC_ASSERT(std::abs(c.terms.goal - least[i].terms.goal) < 0.02);
    RC_ASSERT(c.terms.velocity == least[i].terms.velocity);
    RC_ASSERT(c.terms.danger >= least[i].terms.danger);
    if (most[i].verdict == Verdict::Admissible) RC_ASSERT(c.terms.danger <= most[i].terms.danger);
  }
}

}  // namespace
}  // namespace bslnav
