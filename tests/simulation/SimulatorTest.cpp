#include <bslnav/config/Error.h>
#include <bslnav/simulation/Simulator.h>
#include <gmock/gmock.h>

#include <cstring>
#include <thread>

#include "TestWorld.h"

namespace bslnav {
namespace {

using mrpt::math::TPose2D;
using Contact = SimulationState::Contact;

const RobotOutline kCircle{{}, 0.25, 1.0};

Simulator idealSimulator(const WorldParameters& world) {
  return {world, test::idealRobot(), {{"laser", test::exactLaser()}}, {}, {}, kCircle, 1};
}

/** Everything that one noisy run produces, as bytes. */
std::vector<double> recordedRun(std::uint64_t seed) {
  WorldParameters world;
  world.walls["w"] = test::wall({4, -3}, {4, 3});
  world.cylinders["c"] = {2.0, 1.5, 0.1, 0.0, 1.0, true};
  world.pedestrians["p"] = test::walker({{3, -2}, {3, 2}}, 1.0);
  Simulator simulator(world, {}, {{"laser", LaserParameters{}}}, {}, {}, kCircle, seed);
  std::vector<double> record;
  for (int k = 0; k < 30; ++k) {
    simulator.step({0.5, 0.0, k < 15 ? 0.2 : -0.2}, 0.1);
    const auto& state = simulator.state();
    for (const double value : {state.pose.x, state.pose.y, state.odometry.x, state.odometry.phi,
                               state.clearanceToPeople_m})
      record.push_back(value);
    for (const auto& scan : simulator.senseScans())
      for (std::size_t i = 0; i < scan->getScanSize(); ++i)
        record.push_back(static_cast<double>(scan->getScanRange(i)));
  }
  return record;
}

TEST(Simulator, ContactWithAWallComesWhenTheDistanceIsDriven) {
  WorldParameters world;
  world.walls["w"] = test::wall({2.05, -1}, {2.05, 1});
  auto simulator = idealSimulator(world);
  for (int k = 0; k < 30; ++k) simulator.step({1.0, 0.0, 0.0}, 0.1);
  // Face at 2 m, radius 0.25 m, 1 m/s: 1.75 s; a substep of 10 ms and the model's start of 1 ms.
  EXPECT_EQ(simulator.state().contact, Contact::World);
  EXPECT_NEAR(simulator.state().contactTime_s, 1.75, 0.0111);
  EXPECT_DOUBLE_EQ(simulator.state().speedAtContact_mps, 1.0);
}

TEST(Simulator, PeopleWalkRoundTheRobotButNotThroughWalls) {
  WorldParameters world;
  world.walls["left"] = test::wall({-2, 0.6}, {2, 0.6});
  auto& person = world.pedestrians["p"] = test::walker({{-2, 0.05}, {2, 0.05}}, 1.0);
  person.yieldsWithin_m = 0.6;
  person.walksRoundAfter_s = 1.0;
  auto simulator = idealSimulator(world);
  double side_m = 0.0;
  for (int k = 0; k < 80; ++k) {
    simulator.step({}, 0.1);
    const auto& at = simulator.state().people.front().position;
    if (std::abs(at.x) < 0.1) side_m = at.y;
  }
  EXPECT_NEAR(simulator.state().people.front().position.x, 2.0, 1e-9);
  EXPECT_LT(side_m, -0.59);
  EXPECT_EQ(simulator.state().contact, Contact::Nothing);
}

TEST(Simulator, ContactWithAPersonComesWhenTheGapIsClosed) {
  WorldParameters world;
  world.pedestrians["p"] = test::walker({{3, 0}, {0, 0}}, 1.0);
  auto simulator = idealSimulator(world);
  for (int k = 0; k < 20; ++k) simulator.step({0.6, 0.0, 0.0}, 0.1);
  // Gap 3 - 0.25 - 0.25 = 2.5 m, closing at 1.6 m/s: 1.5625 s.
  EXPECT_EQ(simulator.state().contact, Contact::Person);
  EXPECT_NEAR(simulator.state().contactTime_s, 1.5625, 0.0111);
  EXPECT_DOUBLE_EQ(simulator.state().speedAtContact_mps, 0.6);
}

TEST(Simulator, SmallestClearanceIsKeptOverTheRun) {
  WorldParameters world;
  world.pedestrians["p"] = test::walker({{-3, 1}, {3, 1}}, 1.0);
  auto simulator = idealSimulator(world);
  for (int k = 0; k < 60; ++k) simulator.step({}, 0.1);
  EXPECT_NEAR(simulator.state().minClearanceToPeople_m, 0.5,
              1e-4);  // passes 1 m away: 1 - 0.25 - 0.25
  EXPECT_NEAR(simulator.state().clearanceToPeople_m, std::sqrt(10.0) - 0.5, 1e-9);
  EXPECT_EQ(simulator.state().contact, Contact::Nothing);
}

TEST(Simulator, PersonBehindAWallAppearsAfterTheTrigger) {
  WorldParameters world;
  world.walls["w"] = test::wall({2, -3}, {2, -0.5});
  world.pedestrians["p"] = test::walker({{2.5, -2}, {2.5, 0}}, 1.0);
  world.pedestrians["p"].triggerLine_m = {{0.3, -1}, {0.3, 1}};
  auto simulator = idealSimulator(world);
  simulator.step({0.5, 0.0, 0.0}, 0.5);
  EXPECT_FALSE(simulator.state().people[0].started);
  EXPECT_FALSE(simulator.senseScans().at(0)->getScanRangeValidity(341));  // nobody ahead
  simulator.step({0.5, 0.0, 0.0}, 0.2);                                   // x = 0.35
  EXPECT_TRUE(simulator.state().people[0].started);
  simulator.step({}, 2.5);
  const auto scan = simulator.senseScans().at(0);
  EXPECT_TRUE(scan->getScanRangeValidity(341));
  EXPECT_NEAR(scan->getScanRange(341), 2.5 - 0.25 - 0.35,
              0.002);  // at the end of the walk, on the robot's line
}

TEST(Simulator, ScansComeAtTheirRateWithTheirStamps) {
  auto simulator = idealSimulator({});
  EXPECT_EQ(simulator.senseScans().size(), 1u);  // taken at time 0
  simulator.step({}, 0.09);
  EXPECT_TRUE(simulator.senseScans().empty());
  simulator.step({}, 0.03);
  const auto scans = simulator.senseScans();
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_NEAR(mrpt::Clock::toDouble(scans[0]->timestamp) - Simulator::kEpoch_s, 0.1, 1e-5);
}

TEST(Simulator, ScansComeAfterTheirLatency) {
  auto laser = test::exactLaser();
  laser.latency_s = 0.25;
  Simulator simulator({}, test::idealRobot(), {{"laser", laser}}, {}, {}, kCircle, 1);
  simulator.step({}, 0.2);
  EXPECT_TRUE(simulator.senseScans().empty());
  simulator.step({}, 0.2);
  const auto scans = simulator.senseScans();
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_NEAR(mrpt::Clock::toDouble(scans[0]->timestamp) - Simulator::kEpoch_s, 0.1, 1e-5);
}

TEST(Simulator, LasersAreLabelledByName) {
  Simulator simulator({}, {}, {{"rear", test::exactLaser()}, {"front", test::exactLaser()}}, {}, {},
                      kCircle, 1);
  const auto scans = simulator.senseScans();
  ASSERT_EQ(scans.size(), 2u);
  EXPECT_EQ(scans[0]->sensorLabel, "front");
  EXPECT_EQ(scans[1]->sensorLabel, "rear");
}

TEST(Simulator, AnotherLaserDoesNotChangeTheFirstOnesNoise) {
  WorldParameters world;
  world.walls["w"] = test::wall({2, -3}, {2, 3});
  Simulator one(world, {}, {{"laser", LaserParameters{}}}, {}, {}, kCircle, 3);
  Simulator two(world, {}, {{"a", LaserParameters{}}, {"laser", LaserParameters{}}}, {}, {},
                kCircle, 3);
  const auto first = one.senseScans().at(0), second = two.senseScans().at(1);
  for (std::size_t i = 0; i < first->getScanSize(); ++i)
    ASSERT_EQ(first->getScanRange(i), second->getScanRange(i));
}

TEST(Simulator, EveryLaserHasItsOwnNoise) {
  WorldParameters world;
  world.walls["w"] = test::wall({2, -3}, {2, 3});
  const std::map<std::string, LaserParameters> lasers{{"a", {}}, {"b", {}}};
  const auto scans = Simulator(world, {}, lasers, {}, {}, kCircle, 3).senseScans();
  ASSERT_TRUE(scans[0]->getScanRangeValidity(341) && scans[1]->getScanRangeValidity(341));
  EXPECT_NE(scans[0]->getScanRange(341), scans[1]->getScanRange(341));
}

TEST(Simulator, TimeDoesNotDependOnTheLengthOfSteps) {
  auto fine = idealSimulator({}), coarse = idealSimulator({});
  for (int k = 0; k < 40; ++k) fine.step({0.5, 0.0, 0.3}, 0.025);
  coarse.step({0.5, 0.0, 0.3}, 1.0);
  EXPECT_NEAR(fine.state().time_s, 1.0, 1e-12);
  EXPECT_NEAR(coarse.state().time_s, 1.0, 1e-12);
  EXPECT_NEAR(fine.state().pose.x, coarse.state().pose.x, 1e-3);
}

TEST(Simulator, StartInASolidIsRefusedByName) {
  WorldParameters world;
  world.boxes["crate"] = test::box({0.5, 0, 0}, 1.0, 1.0);
  EXPECT_THAT([&] { idealSimulator(world); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("[box:crate]")));
}

TEST(Simulator, StartInAPersonIsRefused) {
  WorldParameters world;
  world.pedestrians["p"] = test::walker({{0.4, 0}, {3, 0}}, 1.0);
  EXPECT_THROW(idealSimulator(world), Error);
}

TEST(Simulator, RobotPassesBelowAnOverhang) {
  WorldParameters world;
  world.boxes["bridge"] = test::box({1, 0, 0}, 0.5, 4.0, 1.2, 1.4);
  auto simulator = idealSimulator(world);
  simulator.step({1.0, 0.0, 0.0}, 2.0);
  EXPECT_EQ(simulator.state().contact, Contact::Nothing);
}

TEST(Simulator, SameSeedGivesTheSameBytes) {
  const auto a = recordedRun(5), b = recordedRun(5);
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0);
}

TEST(Simulator, OtherSeedGivesOtherNoise) { EXPECT_NE(recordedRun(5), recordedRun(6)); }

TEST(Simulator, SimulatorsInTwoThreadsEqualOneAlone) {
  const auto alone = recordedRun(5);
  std::vector<double> first, second;
  std::thread a([&first] { first = recordedRun(5); });
  std::thread b([&second] { second = recordedRun(5); });
  a.join();
  b.join();
  EXPECT_EQ(first, alone);
  EXPECT_EQ(second, alone);
}

}  // namespace
}  // namespace bslnav
