#include <bslnav/config/Config.h>
#include <bslnav/config/Error.h>
#include <gmock/gmock.h>

#include "DepthCameraRig.h"

namespace bslnav {
namespace {

using test::depth_m;
using test::exactCamera;
using test::frameOf;
using test::kHalfUnit_m;
using test::leftSlope;
using test::upSlope;

TEST(DepthCamera, WallAcrossTheViewHasOneDepth) {
  const auto frame = frameOf(exactCamera(), RayScene(test::wallAt(2.9), {}), {0.9, 0.0, 0.0});
  for (int v = 0; v < 49; ++v)
    for (int u = 0; u < 65; ++u) {
      // The wall is 2 m ahead; below its foot, 0.6 m under the camera, is the floor.
      const double slope = upSlope(*frame, v);
      const double expected = slope * 2.0 > -0.6 ? 2.0 : -0.6 / slope;
      ASSERT_NEAR(depth_m(*frame, u, v), expected, kHalfUnit_m) << u << ' ' << v;
    }
}

TEST(DepthCamera, PositivePitchLooksDownAtTheFloor) {
  auto parameters = exactCamera();
  parameters.pitch_rad = 40.0 * test::kRadPerDeg;
  const auto frame = frameOf(parameters, RayScene({}, {}));
  const double sine = std::sin(parameters.pitch_rad), cosine = std::cos(parameters.pitch_rad);
  EXPECT_NEAR(depth_m(*frame, 32, 24), 0.6 / sine, kHalfUnit_m);
  for (int v = 0; v < 49; ++v) {
    // A point at depth z lies z·(slope·cos − sin) below the camera: 0.6 m for the floor. The
    // uppermost ray still points 40° − 29° down: 2.75 m.
    const double expected = 0.6 / (sine - upSlope(*frame, v) * cosine);
    for (int u = 0; u < 65; ++u)
      ASSERT_NEAR(depth_m(*frame, u, v), expected, kHalfUnit_m) << u << ' ' << v;
  }
}

TEST(DepthCamera, TopOfABoxIsNearerThanTheFloor) {
  WorldParameters world;
  world.boxes["b"] = test::box({0.6, 0.0, 0.0}, 1.0, 0.2, 0.0, 0.4);
  auto parameters = exactCamera();
  parameters.pitch_rad = 30.0 * test::kRadPerDeg;
  const auto frame = frameOf(parameters, RayScene(world, {}));
  // Straight ahead 30° down: the top, 0.2 m lower, after 0.2/sin 30°, 0.35 m from the robot.
  EXPECT_NEAR(depth_m(*frame, 32, 24), 0.4, kHalfUnit_m);
  // 0.4 m ahead the box ends 0.1 m from the axis; column 53 (fx = 34.25) looks 0.25 m aside.
  EXPECT_NEAR(depth_m(*frame, 53, 24), 1.2, kHalfUnit_m);
}

TEST(DepthCamera, PersonIsSeenUpToTheirHeight) {
  auto parameters = exactCamera();
  parameters.z_m = 1.0;
  RayScene scene({}, {{0.25, 1.2}});
  scene.placePeople({{3.0, 0.0}});
  const auto frame = frameOf(parameters, scene);
  for (int v = 0; v < 49; ++v) {
    const double slope = upSlope(*frame, v);  // at the near side, 2.75 m ahead
    if (slope * 2.75 > 0.21) {
      ASSERT_EQ(depth_m(*frame, 32, v), 0.0) << v;  // over the head
    } else if (slope * 2.75 < 0.19 && slope * 2.75 > -1.0) {
      ASSERT_NEAR(depth_m(*frame, 32, v), 2.75, kHalfUnit_m) << v;
    }
  }
  // Beside the axis, at (t, s·t): (t − 3)² + (s·t)² = 0.25².
  const double s = leftSlope(*frame, 30);
  const double expected = (3.0 - std::sqrt(9.0 - (1.0 + s * s) * (9.0 - 0.0625))) / (1.0 + s * s);
  EXPECT_NEAR(depth_m(*frame, 30, 24), expected, kHalfUnit_m);
}

TEST(DepthCamera, SmallPersonIsSeenFromAbove) {
  auto parameters = exactCamera();
  parameters.z_m = 1.0;
  RayScene scene({}, {{0.25, 0.8}});
  scene.placePeople({{1.0, 0.0}});
  const auto frame = frameOf(parameters, scene);
  // fy = 44.2; row 33: slope −9/44.2 = −0.2036: the head, 0.2 m lower, at 0.2/0.2036 = 0.98 m.
  EXPECT_NEAR(depth_m(*frame, 32, 33), -0.2 / upSlope(*frame, 33), kHalfUnit_m);
  // Row 40, slope −0.362: past 0.2 m lower before the near side at 0.75 m.
  EXPECT_NEAR(depth_m(*frame, 32, 40), 0.75, kHalfUnit_m);
  // Row 30, slope −0.136: over the far side at 1.25 m; the floor is at 7.4 m, beyond the range.
  EXPECT_EQ(depth_m(*frame, 32, 30), 0.0);
}

TEST(DepthCamera, MountingPositionAndYawCount) {
  WorldParameters world;
  world.walls["w"] = test::wall({-5, 3}, {5, 3}, 0.2);
  auto parameters = exactCamera();
  parameters.x_m = 0.4;
  parameters.y_m = -0.3;
  parameters.yaw_rad = -M_PI / 2;
  // Robot heading 180°, camera looking to its right: towards +y. It is 0.3 m to the robot's right,
  // at y = 1.3; the face at 2.9 is 1.6 m away.
  const auto frame = frameOf(parameters, RayScene(world, {}), {0.0, 1.0, M_PI});
  EXPECT_NEAR(depth_m(*frame, 32, 24), 1.6, kHalfUnit_m);
}

TEST(DepthCamera, RolledCameraSeesTheFloorAtItsSide) {
  auto parameters = exactCamera();
  parameters.roll_rad = M_PI / 2;  // what was left is now up
  const auto frame = frameOf(parameters, RayScene({}, {}));
  for (int u = 0; u < 65; ++u) {
    const double slope = leftSlope(*frame, u);
    const double floor = slope < -0.1 ? -0.6 / slope : 0.0;  // at −0.1 it is 6 m away
    ASSERT_NEAR(depth_m(*frame, u, 24), floor, kHalfUnit_m) << u;
  }
}

TEST(DepthCamera, RangeLimitsAreOfTheDepth) {
  const RayScene scene(test::wallAt(2.0), {});
  auto parameters = exactCamera();
  // The wall's depth is 2 m in every pixel; the corner (0, 0) is 2·sqrt(1 + 0.93² + 0.54²) away.
  parameters.maxRange_m = 2.01;
  EXPECT_NEAR(depth_m(*frameOf(parameters, scene), 0, 0), 2.0, kHalfUnit_m);
  parameters.maxRange_m = 1.99;
  EXPECT_EQ(depth_m(*frameOf(parameters, scene), 32, 24), 0.0);
  parameters.maxRange_m = 6.0;
  parameters.minRange_m = 1.99;
  EXPECT_NEAR(depth_m(*frameOf(parameters, scene), 32, 24), 2.0, kHalfUnit_m);
  parameters.minRange_m = 2.01;
  EXPECT_EQ(depth_m(*frameOf(parameters, scene), 32, 24), 0.0);
}

TEST(DepthCamera, FrameCarriesItsProperties) {
  DepthCameraParameters parameters;  // 320 × 240, 87° × 58°, pitch 10°
  parameters.x_m = 0.1;
  const auto frame = DepthCamera("front", parameters, 1).frame(RayScene({}, {}), {}, test::kStamp);
  EXPECT_EQ(frame->sensorLabel, "front");
  EXPECT_EQ(frame->timestamp, test::kStamp);
  EXPECT_TRUE(frame->hasRangeImage);
  EXPECT_TRUE(frame->range_is_depth);
  EXPECT_FLOAT_EQ(frame->rangeUnits, 0.001f);
  EXPECT_FLOAT_EQ(frame->maxRange, 6.0f);
  EXPECT_EQ(frame->rangeImage.cols(), 320);
  EXPECT_EQ(frame->rangeImage.rows(), 240);
  EXPECT_EQ(frame->cameraParams.ncols, 320u);
  EXPECT_EQ(frame->cameraParams.nrows, 240u);
  EXPECT_NEAR(frame->cameraParams.fx(), 160.0 / std::tan(43.5 * test::kRadPerDeg), 1e-9);
  EXPECT_NEAR(frame->cameraParams.fy(), 120.0 / std::tan(29.0 * test::kRadPerDeg), 1e-9);
  EXPECT_DOUBLE_EQ(frame->cameraParams.cx(), 159.5);
  EXPECT_DOUBLE_EQ(frame->cameraParams.cy(), 119.5);
  EXPECT_THAT(frame->cameraParams.dist, testing::Each(0.0));
  EXPECT_DOUBLE_EQ(frame->sensorPose.x(), 0.1);
  EXPECT_DOUBLE_EQ(frame->sensorPose.z(), 0.6);
  EXPECT_NEAR(frame->sensorPose.pitch(), 10.0 * test::kRadPerDeg, 1e-12);
}

TEST(DepthCamera, BadParametersAreRefusedBySectionAndKey) {
  using Change = void (*)(DepthCameraParameters&);
  const std::vector<std::pair<const char*, Change>> cases{
      {"hfov_deg", [](DepthCameraParameters& p) { p.hfov_rad = 0.0; }},
      {"vfov_deg", [](DepthCameraParameters& p) { p.vfov_rad = M_PI; }},
      {"columns", [](DepthCameraParameters& p) { p.columns = 1; }},
      {"rows", [](DepthCameraParameters& p) { p.rows = 0; }},
      {"z_m", [](DepthCameraParameters& p) { p.z_m = 0.0; }},
      {"min_range_m", [](DepthCameraParameters& p) { p.minRange_m = std::nan(""); }},
      {"max_range_m", [](DepthCameraParameters& p) { p.maxRange_m = p.minRange_m; }},
      {"max_range_m", [](DepthCameraParameters& p) { p.maxRange_m = 66.0; }},
      {"rate_hz", [](DepthCameraParameters& p) { p.rate_hz = 0.0; }}};
  for (const auto& [key, change] : cases) {
    DepthCameraParameters parameters;
    change(parameters);
    EXPECT_THAT(
        [&p = parameters] { DepthCamera("front", p, 1); },
        testing::ThrowsMessage<Error>(testing::HasSubstr("[camera:front] " + std::string(key))));
  }
}

TEST(DepthCamera, ParametersAreReadInDegrees) {
  std::map<std::string, DepthCameraParameters> cameras;
  Config config;
  config.bindRepeated("camera", "", cameras);
  config.load({}, {"camera:front.pitch_deg=15", "camera:front.noise_coefficient=0.004"});
  EXPECT_NEAR(cameras.at("front").pitch_rad, 15.0 * test::kRadPerDeg, 1e-12);
  EXPECT_EQ(cameras.at("front").noiseCoefficient, 0.004);
  EXPECT_THROW(config.load({}, {"camera:front.hfov_deg=171"}), Error);
}

}  // namespace
}  // namespace bslnav
