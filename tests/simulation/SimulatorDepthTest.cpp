#include <bslnav/simulation/Simulator.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "DepthCameraRig.h"

namespace bslnav {
namespace {

using Cameras = std::map<std::string, DepthCameraParameters>;

const RobotOutline kCircle{{}, 0.25, 1.0};

Simulator simulatorWith(const Cameras& cameras, const WorldParameters& world = {},
                        std::uint64_t seed = 1) {
  return {world, test::idealRobot(), {}, cameras, {}, kCircle, seed};
}

double takenAt_s(const DepthCamera::Frame& frame) {
  return mrpt::Clock::toDouble(frame.timestamp) - Simulator::kEpoch_s;
}

/** All pixels of a noisy drive past a person. */
std::vector<std::uint16_t> recordedRun(std::uint64_t seed) {
  auto world = test::wallAt(4.0);
  world.pedestrians["p"] = test::walker({{3, -2}, {3, 2}}, 1.0);
  auto parameters = test::exactCamera();
  parameters.noiseCoefficient = 0.002;
  auto simulator = simulatorWith({{"camera", parameters}}, world, seed);
  std::vector<std::uint16_t> record;
  for (int k = 0; k < 20; ++k) {
    simulator.step({0.3, 0.0, k < 10 ? 0.2 : -0.2}, 0.1);
    for (const auto& frame : simulator.senseDepth())
      record.insert(record.end(), frame->rangeImage.begin(), frame->rangeImage.end());
  }
  return record;
}

TEST(SimulatorDepth, FramesComeAtTheirRateWithTheirStamps) {
  auto parameters = test::exactCamera();
  parameters.rate_hz = 5.0;
  auto simulator = simulatorWith({{"camera", parameters}});
  EXPECT_EQ(simulator.senseDepth().size(), 1u);  // taken at time 0
  simulator.step({}, 0.19);
  EXPECT_TRUE(simulator.senseDepth().empty());
  simulator.step({}, 0.03);
  const auto frames = simulator.senseDepth();
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_NEAR(takenAt_s(*frames[0]), 0.2, 1e-5);
}

TEST(SimulatorDepth, FramesComeAfterTheirLatency) {
  auto parameters = test::exactCamera();
  parameters.latency_s = 0.25;
  auto simulator = simulatorWith({{"camera", parameters}});
  simulator.step({}, 0.2);
  EXPECT_TRUE(simulator.senseDepth().empty());
  simulator.step({}, 0.2);  // those of 0 and 0.1 s have arrived
  const auto frames = simulator.senseDepth();
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_NEAR(takenAt_s(*frames[0]), 0.1, 1e-5);
}

TEST(SimulatorDepth, FrameShowsTheWorldWhenItWasTaken) {
  auto parameters = test::exactCamera();
  parameters.latency_s = 0.5;
  auto simulator = simulatorWith({{"camera", parameters}}, test::wallAt(3.0));
  simulator.step({1.0, 0.0, 0.0}, 1.0);
  const auto frames = simulator.senseDepth();
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_NEAR(takenAt_s(*frames[0]), 0.5, 1e-5);
  EXPECT_NEAR(test::depth_m(*frames[0], 32, 24), 2.5, 0.002);  // the model starts 1 ms late
}

TEST(SimulatorDepth, CamerasHaveTheirOwnViewAndRateAndAreSortedByName) {
  auto slow = test::exactCamera(), behind = test::exactCamera();
  slow.rate_hz = 1.0;
  behind.yaw_rad = M_PI;
  auto simulator = simulatorWith({{"front", slow}, {"back", behind}}, test::wallAt(3.0));
  auto frames = simulator.senseDepth();
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0]->sensorLabel, "back");
  EXPECT_EQ(frames[1]->sensorLabel, "front");
  EXPECT_EQ(test::depth_m(*frames[0], 32, 24), 0.0);
  EXPECT_NEAR(test::depth_m(*frames[1], 32, 24), 3.0, test::kHalfUnit_m);
  simulator.step({}, 0.1);
  frames = simulator.senseDepth();
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0]->sensorLabel, "back");
}

TEST(SimulatorDepth, WalkingPersonIsSeenWhereTheyAre) {
  WorldParameters world;
  world.pedestrians["p"] = test::walker({{3, -2}, {3, 0}}, 1.0);
  auto simulator = simulatorWith({{"camera", test::exactCamera()}}, world);
  EXPECT_EQ(test::depth_m(*simulator.senseDepth().at(0), 32, 24), 0.0);
  simulator.step({}, 2.0);
  EXPECT_NEAR(test::depth_m(*simulator.senseDepth().at(0), 32, 24), 2.75, test::kHalfUnit_m);
}

TEST(SimulatorDepth, OtherSensorsDoNotChangeACamerasNoise) {
  const auto world = test::wallAt(3.0);
  const DepthCameraParameters camera;
  auto one = simulatorWith({{"c", camera}}, world);
  Simulator many(world, test::idealRobot(), {{"laser", LaserParameters{}}},
                 {{"a", camera}, {"c", camera}}, {}, kCircle, 1);
  const auto first = one.senseDepth().at(0), second = many.senseDepth().at(1);
  EXPECT_TRUE(
      std::equal(first->rangeImage.begin(), first->rangeImage.end(), second->rangeImage.begin()));
}

TEST(SimulatorDepth, CamerasDoNotChangeALasersNoise) {
  const auto world = test::wallAt(3.0);
  const std::map<std::string, LaserParameters> lasers{{"laser", {}}};
  Simulator without(world, test::idealRobot(), lasers, {}, {}, kCircle, 1);
  Simulator with(world, test::idealRobot(), lasers, {{"c", {}}}, {}, kCircle, 1);
  const auto a = without.senseScans().at(0), b = with.senseScans().at(0);
  for (std::size_t i = 0; i < a->getScanSize(); ++i)
    ASSERT_EQ(a->getScanRange(i), b->getScanRange(i));
}

TEST(SimulatorDepth, EveryCameraHasItsOwnNoise) {
  const auto frames = simulatorWith({{"a", {}}, {"b", {}}}, test::wallAt(3.0)).senseDepth();
  EXPECT_FALSE(std::equal(frames[0]->rangeImage.begin(), frames[0]->rangeImage.end(),
                          frames[1]->rangeImage.begin()));
}

TEST(SimulatorDepth, SeedAloneDecidesWhateverTheThreads) {
  const auto alone = recordedRun(5);
  std::vector<std::uint16_t> first, second;
  std::thread a([&first] { first = recordedRun(5); });
  std::thread b([&second] { second = recordedRun(6); });
  a.join();
  b.join();
  EXPECT_EQ(first, alone);
  EXPECT_NE(second, alone);
}

}  // namespace
}  // namespace bslnav
