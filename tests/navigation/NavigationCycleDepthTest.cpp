#include <bslnav/navigation/NavigationCycle.h>
#include <gmock/gmock.h>
#include <mrpt/core/Clock.h>

#include "../support/DepthScene.h"
#include "../support/HeapUse.h"
#include "NavigationCycleRig.h"

namespace bslnav {
namespace {

using mrpt::obs::CObservation3DRangeScan;
using test::cameraAt;
using test::DepthScene;
using Health = CycleRecord::Health;

constexpr double kEpoch_s = 1e9;

/** A corner on the right: its wall ends 2.5 m ahead at y = -0.8. */
const DepthScene kCorner{{{0.9, 2.5, -1.0, -0.8, 0.0, 2.0}}, 0.0};

NavigationParameters method3() {
  NavigationParameters parameters;
  parameters.depth.enabled = true;
  parameters.blindSpots.source = BlindSpotSource::DepthClusters;
  parameters.depthClusters.fewestVoxels = 50;
  return parameters;
}

CObservation3DRangeScan::ConstPtr taken(CObservation3DRangeScan image, double time_s,
                                        const char* label = "camera") {
  image.sensorLabel = label;
  image.timestamp = mrpt::Clock::fromDouble(kEpoch_s + time_s);
  return std::make_shared<const CObservation3DRangeScan>(std::move(image));
}

SensorFrame frameAt(double time_s, double x_m = 0.0) {
  SensorFrame frame;
  frame.time_s = time_s;
  frame.startTime_s = kEpoch_s;
  frame.odometry = frame.mapFromRobot = {x_m, 0.0, 0.0};
  return frame;
}

class NavigationCycleDepth : public testing::Test {
 protected:
  const CycleRecord& see(CObservation3DRangeScan image, double time_s) {
    SensorFrame frame = frameAt(time_s);
    frame.depth = {taken(std::move(image), time_s)};
    return cycle_.step(frame);
  }

  CObservation3DRangeScan corner_ = kCorner.picture(cameraAt(0.6, 0.1), 160, 120);
  NavigationCycle cycle_{method3(), nullptr};
};

TEST_F(NavigationCycleDepth, FindsWhereTheWallEnds) {
  const CycleRecord& record = see(corner_, 0.0);
  EXPECT_EQ(record.health, Health::Ok);
  ASSERT_EQ(record.blindSpots.size(), 1U);
  EXPECT_NEAR(record.blindSpots[0].position.x, 2.5, 0.06);
  EXPECT_EQ(record.dangerZones.size(), 1U);
  EXPECT_EQ(cycle_.surroundings().depthFrames().size(), 1U);
}

TEST_F(NavigationCycleDepth, PutsALateImageWhereItWasTaken) {
  cycle_.step(frameAt(0.0, 0.0));
  SensorFrame late = frameAt(0.2, 0.3);
  late.depth = {
      taken(corner_, 0.1)};  // half way, at x = 0.15 m: the corner is at 2.65 m in the map
  const CycleRecord& record = cycle_.step(late);
  ASSERT_EQ(record.dangerZones.size(), 1U);
  EXPECT_NEAR(record.dangerZones[0].centre.x, 2.65, 0.06);
}

TEST_F(NavigationCycleDepth, KeepsItsZonesBetweenTheImagesOfASlowCamera) {
  see(corner_, 0.0);
  const CycleRecord& record = cycle_.step(frameAt(0.1, 0.05));
  EXPECT_EQ(record.health, Health::Ok);
  EXPECT_EQ(record.depthFrames, 0);
  EXPECT_EQ(record.dangerZones.size(), 1U);
}

TEST_F(NavigationCycleDepth, JoinsCamerasOfDifferentRates) {
  auto left =
      DepthScene{{{1.2, 1.6, 1.2, 1.6, 0.0, 2.0}}, 0.0}.picture(cameraAt(0.6, 0.1, 0.9), 160, 120);
  SensorFrame both = frameAt(0.0);
  both.depth = {taken(corner_, 0.0), taken(left, 0.0, "left")};
  EXPECT_EQ(cycle_.step(both).blindSpots.size(), 2U);
  EXPECT_EQ(see(corner_, 0.1).blindSpots.size(), 2U);  // the left one's image is 0.1 s old
  for (int i = 2; i < 8; ++i) see(corner_, 0.1 * i);
  EXPECT_EQ(see(corner_, 0.8).health, Health::StaleSensor);  // 0.8 s without the left one
}

TEST_F(NavigationCycleDepth, StopsAndSaysWhyWhenImagesAreNoUse) {
  auto uncalibrated = corner_;
  uncalibrated.cameraParams.setIntrinsicParamsFromValues(0.0, 0.0, 0.0, 0.0);
  auto blind = corner_;
  blind.rangeImage.fill(0);
  auto low = corner_;
  low.sensorPose.z(0.2);
  const std::pair<CObservation3DRangeScan, const char*> cases[] = {
      {uncalibrated, "calibration"}, {blind, "no pixel"}, {low, "pose is wrong"}};
  for (const auto& [image, why] : cases) {
    NavigationCycle cycle(method3(), nullptr);
    cycle.expectSensor(SensorKind::Camera, "camera");
    SensorFrame frame = frameAt(0.0);
    frame.twist = {0.5, 0.0, 0.0};
    frame.depth = {taken(image, 0.0)};
    const CycleRecord& record = cycle.step(frame);
    EXPECT_EQ(record.health, Health::StaleSensor);
    EXPECT_EQ(record.droppedDepthFrames, 1);
    EXPECT_THAT(reasonOf(record), testing::AllOf(testing::HasSubstr("depth camera 'camera'"),
                                                 testing::HasSubstr(why)));
    EXPECT_LT(record.motion.command.vx, 0.5);
  }
}

/** 0.3 m before a wall every depth is below the camera's least, and that is no defect, from the
 * first image on; farther away it is. */
TEST_F(NavigationCycleDepth, ACameraThatIsTooNearToAWallIsNotBroken) {
  auto blind = corner_;
  blind.rangeImage.fill(0);
  const auto step = [&](double time_s, double wall_m) {
    SensorFrame frame = frameAt(time_s, 0.3 - wall_m);
    frame.scans = {test::makeScan(time_s, [wall_m](int deg) {
      return std::abs(deg) < 80 ? wall_m / std::cos(deg * M_PI / 180.0) : 0.0;
    })};
    frame.depth = {taken(blind, time_s)};
    return cycle_.step(frame);
  };
  for (int i = 0; i < 12; ++i) {
    const CycleRecord record = step(0.1 * i, 0.3);
    ASSERT_EQ(record.health, Health::Ok) << i;
    EXPECT_EQ(record.droppedDepthFrames, 1);
  }
  EXPECT_EQ(step(1.8, 0.9).health, Health::StaleSensor);
}

/** What it saw before is too old by then. */
TEST_F(NavigationCycleDepth, ForgetsItsZonesWhenTheCameraSeesNothingForLong) {
  ASSERT_EQ(see(corner_, 0.0).dangerZones.size(), 1U);
  auto blind = corner_;
  blind.rangeImage.fill(0);
  for (int i = 1; i < 8; ++i) {
    SensorFrame frame = frameAt(0.1 * i);
    frame.scans = {test::makeScan(0.1 * i, [](int deg) {
      return std::abs(deg) < 80 ? 0.3 / std::cos(deg * M_PI / 180.0) : 0.0;
    })};
    frame.depth = {taken(blind, 0.1 * i)};
    const CycleRecord& record = cycle_.step(frame);
    ASSERT_EQ(record.health, Health::Ok);
    if (i == 5) continue;  // just too old, or not yet
    EXPECT_EQ(record.dangerZones.size(), i < 5 ? 1U : 0U) << i;
  }
}

/** At a wall, too, an image without depth does not take the place of one with. */
TEST_F(NavigationCycleDepth, ABlindImageAtAWallLeavesTheOneBefore) {
  auto blind = corner_;
  blind.rangeImage.fill(0);
  SensorFrame frame = frameAt(0.0);
  frame.scans = {test::makeScan(
      0.0, [](int deg) { return std::abs(deg) < 80 ? 0.3 / std::cos(deg * M_PI / 180.0) : 0.0; })};
  frame.depth = {taken(corner_, 0.0), taken(blind, 0.0)};
  EXPECT_EQ(cycle_.step(frame).blindSpots.size(), 1U);
}

TEST_F(NavigationCycleDepth, AnUnusableSecondImageLeavesTheFirst) {
  auto blind = corner_;
  blind.rangeImage.fill(0);
  SensorFrame frame = frameAt(0.0);
  frame.depth = {taken(corner_, 0.0), taken(blind, 0.0)};
  EXPECT_EQ(cycle_.step(frame).blindSpots.size(), 1U);
}

TEST_F(NavigationCycleDepth, NamesTheCameraThatIsNoUseThoughAnotherOneIsFine) {
  auto blind = corner_;
  blind.rangeImage.fill(0);
  for (int i = 0; i < 10; ++i) {  // the bad one was never announced, and never usable
    SensorFrame frame = frameAt(0.1 * i);
    frame.depth = {taken(blind, 0.1 * i, "bad"), taken(corner_, 0.1 * i, "good")};
    const CycleRecord& record = cycle_.step(frame);
    EXPECT_EQ(record.health, Health::StaleSensor);
    EXPECT_THAT(reasonOf(record),
                testing::AllOf(testing::HasSubstr("'bad'"), testing::HasSubstr("no pixel")));
  }
  SensorFrame silent = frameAt(1.0);
  silent.depth = {taken(corner_, 1.0, "good")};
  EXPECT_THAT(reasonOf(cycle_.step(silent)), testing::HasSubstr("'bad'"));
}

TEST_F(NavigationCycleDepth, TwoCamerasOfDifferentRatesAllocateNothing) {
  std::vector<SensorFrame> frames;
  for (int i = 0; i < 12; ++i) {
    frames.push_back(frameAt(0.1 * i));
    frames.back().depth = {taken(corner_, 0.1 * i, "fast")};
    if (i % 3 == 0) frames.back().depth.push_back(taken(corner_, 0.1 * i, "slow"));
  }
  for (std::size_t i = 0; i < 6; ++i) cycle_.step(frames[i]);
  const long before = test::heapUse().allocations;
  for (std::size_t i = 6; i < 12; ++i) cycle_.step(frames[i]);
  EXPECT_EQ(test::heapUse().allocations, before);
}

TEST_F(NavigationCycleDepth, IgnoresDepthThatIsNotEnabled) {
  NavigationCycle cycle(NavigationParameters{}, nullptr);
  SensorFrame frame = frameAt(0.0);
  frame.depth = {taken(corner_, 0.0)};
  EXPECT_EQ(cycle.step(frame).depthFrames, 0);
  EXPECT_TRUE(cycle.surroundings().depthFrames().empty());
}

TEST_F(NavigationCycleDepth, AllocatesNothingInTheSteadyState) {
  std::vector<SensorFrame> frames;
  for (int i = 0; i < 6; ++i) {
    frames.push_back(frameAt(0.1 * i));
    frames.back().depth = {taken(corner_, 0.1 * i)};
  }
  for (int i = 0; i < 3; ++i) cycle_.step(frames[static_cast<std::size_t>(i)]);
  const long before = test::heapUse().allocations;
  for (int i = 3; i < 6; ++i) cycle_.step(frames[static_cast<std::size_t>(i)]);
  EXPECT_EQ(test::heapUse().allocations, before);
}

/** With the guard, too: its grids, its tracks, and how far the camera sees people. */
TEST_F(NavigationCycleDepth, TheGuardAllocatesNothingInTheSteadyState) {
  NavigationParameters parameters = method3();
  parameters.blindSpots.source = BlindSpotSource::None;
  parameters.guard.enabled = true;
  NavigationCycle cycle(parameters, nullptr);
  cycle.setGoals({{3.0, 0.0, 0.0}});
  std::vector<SensorFrame> frames;
  for (int i = 0; i < 16; ++i) {
    frames.push_back(frameAt(0.1 * i));
    frames.back().depth = {taken(corner_, 0.1 * i)};
  }
  long before = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    if (i == 11) before = test::heapUse().allocations;  // a new path is due at 1.0 s
    EXPECT_TRUE(cycle.step(frames[i]).guard.active);
  }
  EXPECT_EQ(test::heapUse().allocations, before);
}

/** A camera sees over a low box: what is behind it is no place to step out from. */
TEST_F(NavigationCycleDepth, ALowBoxHidesNobodyFromTheGuard) {
  NavigationParameters parameters = method3();
  parameters.guard.enabled = true;
  const auto hidden = [&parameters](double boxHeight_m) {
    const DepthScene room{
        {{1.5, 2.0, -0.5, 0.5, 0.0, boxHeight_m}, {3.0, 3.2, -9.0, 9.0, 0.0, 3.0}}, 0.0};
    NavigationCycle cycle(parameters, nullptr);
    cycle.setGoals({{1.0, 0.0, 0.0}});
    SensorFrame frame = frameAt(0.0);
    frame.depth = {taken(room.picture(cameraAt(0.6, 0.1), 160, 120), 0.0)};
    cycle.step(frame);
    int near = 0;  // not at the wall
    for (const auto& p : cycle.surroundings().people()->frontier())
      near += p.x_m < 2.6f && std::abs(p.y_m) < 0.5f;
    return near;
  };
  EXPECT_EQ(hidden(0.35), 0);
  EXPECT_GT(hidden(1.8), 0);
}

TEST(MotionHistory, InterpolatesAndKnowsItsEnds) {
  MotionHistory motion;
  EXPECT_EQ(motion.nowFromThen(1.0), mrpt::math::TPose2D());
  motion.add(0.0, {0.0, 0.0, 0.0});
  motion.add(1.0, {1.0, 0.0, 0.0});
  motion.add(2.0, {2.0, 0.0, M_PI / 2});
  EXPECT_EQ(motion.nowFromThen(2.5), mrpt::math::TPose2D());
  const auto then = motion.nowFromThen(0.5);  // 1.5 m back along x; the robot now looks along y
  EXPECT_NEAR(then.x, 0.0, 1e-9);
  EXPECT_NEAR(then.y, 1.5, 1e-9);
  EXPECT_NEAR(then.phi, -M_PI / 2, 1e-9);
  EXPECT_NEAR(motion.nowFromThen(-3.0).y, 2.0, 1e-9);
  motion.clear();
  EXPECT_EQ(motion.nowFromThen(0.5), mrpt::math::TPose2D());
}

}  // namespace
}  // namespace bslnav
