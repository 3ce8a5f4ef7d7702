#include <bslnav/planning/DwaPlanner.h>
#include <bslnav/planning/DynamicWindow.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "DwaGenerators.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;
using test::any;
using Verdict = Candidate::Verdict;

constexpr double kPeriod_s = 0.1;

/** A robot near the origin of a cluttered map with a path along x, a circle or a rectangle; every
 * other one can move sideways. */
struct Scene {
  RobotLimits limits = *rc::gen::arbitrary<bool>() ? test::anyHolonomicLimits() : test::anyLimits();
  Footprint footprint = *rc::gen::element(Footprint{0.2}, test::rectangle(0.5, 0.3));
  InflationLayer inflation{{0.5, 8.0}, footprint.inscribedRadius_m(), 0.05};
  CostGrid base = test::scattered(25);
  DwaParameters parameters;
  TPose2D pose{any(-1.0, 1.0), any(-1.0, 1.0), any(-M_PI, M_PI)};
  mrpt::math::TTwist2D twist = test::anyTwist(limits);
  std::vector<TPoint2D> path = test::straightPath(2.5);
  TPoint2D goal{2.025, 0.025};  // the middle of a cell

  Scene() {
    parameters.speedSamples = 8;
    parameters.yawRateSamples = 11;
    parameters.lateralSamples = 3;
    parameters.allowUnknown = *rc::gen::arbitrary<bool>();
    parameters.weights.velocity = *rc::gen::element(0.0, 0.5);
  }
  Cost goalCost() const { return test::inflated(base, inflation).costAt(goal.x, goal.y); }
  DwaResult plan() const {
    DwaPlanner planner(parameters, limits, FootprintCover(footprint, 0.05, inflation), kPeriod_s);
    return planner.plan({pose, twist, path, goal, 0.1}, test::inflated(base, inflation));
  }
};

RC_GTEST_PROP(DwaPlannerLaw, CommandsStayInTheWindowAndTheLimits, ()) {
  const Scene scene;
  const DwaResult result = scene.plan();
  const auto window =
      dynamicWindow(scene.twist, scene.limits, kPeriod_s, scene.limits.maxSpeed_mps);
  const auto allowed = limited(result.command, scene.twist, scene.limits, kPeriod_s);
  RC_CLASSIFY(result.status == DwaResult::Status::Ok, "admissible");
  RC_ASSERT(std::abs(allowed.vx - result.command.vx) < 1e-9);
  RC_ASSERT(std::abs(allowed.vy - result.command.vy) < 1e-9);
  RC_ASSERT(std::abs(allowed.omega - result.command.omega) < 1e-9);
  if (scene.limits.maxLateralSpeed_mps > 0.0) return;  // the window is one of vx and vy by itself
  RC_ASSERT(result.command.vx >= window.vMin - 1e-9);
  RC_ASSERT(result.command.vx <= window.vMax + 1e-9);
  RC_ASSERT(
      (result.command.omega >= window.wMin - 1e-9 && result.command.omega <= window.wMax + 1e-9));
}

RC_GTEST_PROP(DwaPlannerLaw, AnotherObstacleAdmitsNothingAndLowersNoDanger, ()) {
  Scene scene;
  const DwaResult before = scene.plan();
  const Cost goalCost = scene.goalCost();
  const int x = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(20, 100));
  const int y = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(20, 100));
  scene.base.at(x, y) = kLethalCost;
  RC_PRE(scene.goalCost() == goalCost);  // the goal's own cost is no danger to a rollout to it
  const DwaResult after = scene.plan();
  int worse = 0;
  for (std::size_t i = 0; i < before.candidates.size(); ++i) {
    const Candidate &old = before.candidates[i], &now = after.candidates[i];
    if (now.verdict != Verdict::Admissible) {
      worse += old.verdict == Verdict::Admissible;
      continue;
    }
    RC_ASSERT(old.verdict == Verdict::Admissible);
    RC_ASSERT(now.terms.danger >= old.terms.danger);
    worse += now.terms.danger > old.terms.danger;
  }
  RC_CLASSIFY(worse > 0, "it mattered");
}

/** The scene, moved by whole cells: the map's corner moves along. */
Scene moved(Scene scene, int dx, int dy) {
  CostGrid base(scene.base.width(), scene.base.height(), 0.05, -3.0 + 0.05 * dx, -3.0 + 0.05 * dy);
  std::copy(scene.base.begin(), scene.base.end(), base.begin());
  scene.base = base;
  const TPoint2D by{0.05 * dx, 0.05 * dy};
  scene.pose.x += by.x;
  scene.pose.y += by.y;
  for (auto& p : scene.path) p = p + by;
  scene.goal = scene.goal + by;
  return scene;
}

/** The scene after a quarter turn to the left about the origin. */
Scene turned(Scene scene) {
  const auto turn = [](const TPoint2D& p) { return TPoint2D{-p.y, p.x}; };
  CostGrid base = scene.base;
  for (int y = 0; y < base.height(); ++y)
    for (int x = 0; x < base.width(); ++x) base.at(base.width() - 1 - y, x) = scene.base.at(x, y);
  scene.base = base;
  scene.pose = {-scene.pose.y, scene.pose.x, scene.pose.phi + M_PI / 2};
  for (auto& p : scene.path) p = turn(p);
  scene.goal = turn(scene.goal);
  return scene;
}

/** The same answer, but for rollouts that pass so near to a cell's border that rounding decides. */
void expectSame(const DwaResult& a, const DwaResult& b) {
  int different = 0;
  for (std::size_t i = 0; i < a.candidates.size(); ++i) {
    const Candidate &p = a.candidates[i], &q = b.candidates[i];
    RC_ASSERT(std::abs(p.v_mps - q.v_mps) < 1e-9 && std::abs(p.vy_mps - q.vy_mps) < 1e-9 &&
              std::abs(p.w_radps - q.w_radps) < 1e-9);
    different += p.verdict != q.verdict || std::abs(p.total - q.total) > 1e-3;
  }
  RC_ASSERT(different * 22 <= static_cast<int>(a.candidates.size()));  // 4 of 88
  if (different == 0 && a.best != b.best) {
    const auto total = [](const DwaResult& r) {
      return r.candidates[static_cast<std::size_t>(r.best)].total;
    };
    // a tie; with lateral motion, of those that lead the same way
    RC_ASSERT(std::abs(total(a) - total(b)) < (a.candidates.size() > 88 ? 2.2e-2 : 2e-3));
  }
}

RC_GTEST_PROP(DwaPlannerLaw, MovingTheWorldMovesTheAnswer, ()) {
  const Scene scene;
  expectSame(scene.plan(),
             moved(scene, *rc::gen::inRange(-300, 300), *rc::gen::inRange(-300, 300)).plan());
}

RC_GTEST_PROP(DwaPlannerLaw, TurningTheWorldTurnsTheAnswer, ()) {
  const Scene scene;
  expectSame(scene.plan(), turned(scene).plan());
}

RC_GTEST_PROP(DwaPlannerLaw, TheSameInputGivesTheSameBits, ()) {
  const Scene scene;
  const DwaResult a = scene.plan(), b = scene.plan();
  RC_ASSERT(a.best == b.best);
  for (std::size_t i = 0; i < a.candidates.size(); ++i)
    RC_ASSERT(a.candidates[i].total == b.candidates[i].total);
}

}  // namespace
}  // namespace bslnav
