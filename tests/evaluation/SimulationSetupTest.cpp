#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "EvaluationRig.h"

namespace bslnav {
namespace {

using test::errorOf;
using test::hall;
using test::s1;
using testing::HasSubstr;

const PedestrianParameters& personOf(const SimulationSetup& setup) {
  return setup.world.pedestrians.begin()->second;
}

RC_GTEST_PROP(Varied, StaysWithinTheScenariosVariationAndIsRepeatable, ()) {
  static const SimulationSetup setup = s1(1);
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const SimulationSetup a = varied(setup, seed), b = varied(setup, seed);
  const auto& plain = personOf(setup);
  const double shift = personOf(a).triggerLine_m[0].x - plain.triggerLine_m[0].x;
  RC_ASSERT(std::abs(shift) <= 0.8);
  RC_ASSERT(std::abs(personOf(a).speed_mps / plain.speed_mps - 1.0) <= 0.1 + 1e-12);
  RC_ASSERT(personOf(a).speed_mps == personOf(b).speed_mps);
  for (const std::size_t i : {0u, 1u}) {  // the line is moved, not turned
    RC_ASSERT(personOf(a).triggerLine_m[i] == personOf(b).triggerLine_m[i]);
    RC_ASSERT(personOf(a).triggerLine_m[i].y == plain.triggerLine_m[i].y);
    RC_ASSERT(std::abs(personOf(a).triggerLine_m[i].x - plain.triggerLine_m[i].x - shift) < 1e-9);
  }
}

TEST(Varied, DiffersFromSeedToSeedAndUsesTheWholeRange) {
  const SimulationSetup setup = s1(1);
  const double plain_m = personOf(setup).triggerLine_m[0].x;
  std::set<double> shifts_m;
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
    shifts_m.insert(personOf(varied(setup, seed)).triggerLine_m[0].x - plain_m);
  EXPECT_EQ(shifts_m.size(), 40u);
  const double most_m = setup.scenario.triggerVariation_m;
  EXPECT_LT(*shifts_m.begin(), -0.75 * most_m);  // missed by 40 uniform draws once in 200 cases
  EXPECT_GT(*shifts_m.rbegin(), 0.75 * most_m);
}

TEST(Varied, ChangesNothingWithoutVariation) {
  SimulationSetup setup = s1(1);
  setup.scenario.triggerVariation_m = setup.scenario.speedVariation = 0.0;
  const SimulationSetup same = varied(setup, 3);
  EXPECT_EQ(personOf(same).speed_mps, personOf(setup).speed_mps);
  EXPECT_EQ(personOf(same).triggerLine_m[1], personOf(setup).triggerLine_m[1]);
}

TEST(SimulationSetup, RefusesAGoalOutsideTheMap) {
  SimulationSetup setup = hall();
  setup.scenario.goals = {{5.0, 0.0, 0.0}, {20.0, 0.0, 0.0}};
  EXPECT_THAT(errorOf([&] { setup.makeMap(); }), HasSubstr("[scenario] goals"));
  EXPECT_THAT(errorOf([&] { runSimulation(setup, 1); }), HasSubstr("[scenario] goals"));
}

TEST(SimulationSetup, RefusesNoGoalAndNoLaser) {
  SimulationSetup setup = hall();
  setup.scenario.goals.clear();
  EXPECT_THAT(errorOf([&] { setup.check(); }), HasSubstr("[scenario] goals"));
  setup = hall();
  setup.lasers.clear();
  EXPECT_THAT(errorOf([&] { setup.check(); }), HasSubstr("laser"));
}

TEST(SimulationSetup, RefusesDepthWithoutACameraAndABadCamera) {
  SimulationSetup setup = hall();
  setup.navigation.depth.enabled = true;
  EXPECT_THAT(errorOf([&] { setup.check(); }), HasSubstr("[camera:NAME] columns"));
  setup.cameras["front"];
  EXPECT_EQ(errorOf([&] { setup.check(); }), "");
  setup.cameras["front"].maxRange_m = 0.2;  // below the minimum of 0.3 m
  EXPECT_THAT(errorOf([&] { setup.check(); }), HasSubstr("[camera:front] max_range_m"));
}

TEST(SimulationSetup, RefusesAMissingMapFileAndAParticleFilterWithoutAMap) {
  SimulationSetup setup = hall();
  setup.scenario.map = "no_such_map.yaml";
  EXPECT_THAT(errorOf([&] { runSimulation(setup, 1); }), HasSubstr("no_such_map.yaml"));
  setup.scenario.map = "none";
  setup.localization.source = PoseSource::ParticleFilter;
  EXPECT_THAT(errorOf([&] { runSimulation(setup, 1); }), HasSubstr("[localization] source"));
}

TEST(SimulationSetup, RefusesLateralMotionOfABaseThatCannot) {
  SimulationSetup setup = hall();
  setup.navigation.dwa.lateralSamples = 5;
  setup.navigation.limits.maxLateralSpeed_mps = 0.3;
  EXPECT_THAT(errorOf([&] { setup.check(); }), HasSubstr("[limits] max_lateral_speed_mps"));
  setup.simulatedRobot.kinematics = BaseKinematics::Holonomic;
  EXPECT_EQ(errorOf([&] { setup.check(); }), "");
  setup.navigation.limits.maxLateralSpeed_mps = 1.5;  // the base does 1.0 m/s
  EXPECT_THAT(errorOf([&] { setup.check(); }), HasSubstr("[limits] max_lateral_speed_mps"));
  setup.navigation.limits.maxLateralSpeed_mps = 0.3;
  setup.navigation.dwa.lateralSamples = 1;
  EXPECT_THAT(errorOf([&] { setup.check(); }), HasSubstr("[dwa] lateral_samples"));
}

TEST(SimulationSetup, RefusesAStartInCollision) {
  SimulationSetup setup = hall();
  setup.scenario.start = {0.0, 1.8, 0.0};  // 0.15 m from the wall's face, radius 0.25 m
  EXPECT_THAT(errorOf([&] { runSimulation(setup, 1); }), HasSubstr("wall:hall"));
}

}  // namespace
}  // namespace bslnav
