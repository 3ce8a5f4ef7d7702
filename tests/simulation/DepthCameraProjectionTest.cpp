#include <gtest/gtest.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>

#include "DepthCameraRig.h"

namespace bslnav {
namespace {

using mrpt::math::TPose2D;
using mrpt::poses::CPose3D;

/** A camera mounted askew. */
DepthCameraParameters askew() {
  auto parameters = test::exactCamera();
  parameters.x_m = 0.1;
  parameters.y_m = 0.05;
  parameters.z_m = 0.7;
  parameters.yaw_rad = 10.0 * test::kRadPerDeg;
  parameters.pitch_rad = 15.0 * test::kRadPerDeg;
  parameters.roll_rad = 5.0 * test::kRadPerDeg;
  return parameters;
}

/** MRPT's points of a frame in the map frame. */
mrpt::maps::CSimplePointsMap pointsOf(const DepthCamera::Frame& frame, const TPose2D& robot) {
  auto copy = frame;
  mrpt::obs::T3DPointsProjectionParams projection;
  projection.takeIntoAccountSensorPoseOnRobot = true;
  projection.robotPoseInTheWorld = CPose3D(mrpt::math::TPose3D(robot));
  mrpt::maps::CSimplePointsMap points;
  copy.unprojectInto(points, projection);
  return points;
}

TEST(DepthCameraProjection, PointsLieOnTheSurfacesOfTheWorld) {
  WorldParameters world;
  world.walls["ahead"] = test::wall({3.1, -5}, {3.1, 5}, 0.2);  // face x = 3
  world.walls["left"] = test::wall({-5, 1.6}, {5, 1.6}, 0.2);   // face y = 1.5
  world.walls["ahead"].zMax_m = world.walls["left"].zMax_m = 5.0;
  const TPose2D robot{0.3, -0.2, 0.4};
  const auto frame = test::frameOf(askew(), RayScene(world, {}), robot);
  const auto points = pointsOf(*frame, robot);
  const auto seen = std::count_if(frame->rangeImage.begin(), frame->rangeImage.end(),
                                  [](std::uint16_t depth) { return depth > 0; });
  ASSERT_EQ(points.size(), static_cast<std::size_t>(seen));
  std::array<int, 3> hits{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    float x = 0, y = 0, z = 0;
    points.getPoint(i, x, y, z);
    const std::array<float, 3> off{std::abs(x - 3.0f), std::abs(y - 1.5f), std::abs(z)};
    const auto nearest = std::min_element(off.begin(), off.end());
    // Half a millimetre of depth is at most sqrt(1 + 0.95² + 0.55²)/2 = 0.75 mm along the ray.
    ASSERT_LT(*nearest, 0.001f) << x << ' ' << y << ' ' << z;
    ++hits[static_cast<std::size_t>(nearest - off.begin())];
  }
  for (const int count : hits) EXPECT_GT(count, 300);  // of 3185 pixels
}

RC_GTEST_PROP(DepthCameraProjection, PixelsEqualSingleRays, ()) {
  const auto number = [](int low, int high) { return *rc::gen::inRange(low, high) / 100.0; };
  WorldParameters world;
  for (int i = 0; i < 4; ++i)
    world.boxes[std::to_string(i)] =
        test::box({number(100, 400), number(-200, 200), number(-314, 314)}, number(10, 100), 0.3,
                  0.0, number(10, 200));
  world.cylinders["c"] = {2.0, number(-100, 100), 0.1, 0.0, 1.0, true};
  RayScene scene(world, {{0.25, number(50, 180)}});
  scene.placePeople({{number(100, 300), number(-100, 100)}});
  const TPose2D robot(number(-50, 50), number(-50, 50), number(-50, 50));
  const auto parameters = askew();
  const auto frame = test::frameOf(parameters, scene, robot);
  const CPose3D camera = CPose3D(mrpt::math::TPose3D(robot)) + frame->sensorPose;
  const auto depthAlong = [&](double left, double up) {
    const double length = std::sqrt(1.0 + left * left + up * up);
    const auto d = camera.rotateVector({1.0 / length, left / length, up / length});
    return scene.rayHit({static_cast<float>(camera.x()), static_cast<float>(camera.y()),
                         static_cast<float>(camera.z())},
                        {static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)},
                        20.0f) /
           length;
  };
  for (int i = 0; i < 200; ++i) {
    const int u = *rc::gen::inRange(0, 65), v = *rc::gen::inRange(0, 49);
    const double left = test::leftSlope(*frame, u), up = test::upSlope(*frame, v);
    // At a silhouette rounding decides what a ray meets: then it is what a ray beside it meets.
    double low = depthAlong(left, up), high = low;
    for (const double step : {-1e-5, 1e-5})
      for (const double depth : {depthAlong(left + step, up), depthAlong(left, up + step)}) {
        low = std::min(low, depth);
        high = std::max(high, depth);
      }
    const double depth = test::depth_m(*frame, u, v);
    if (low > 6.0 || high < 0.3)
      RC_ASSERT(depth == 0.0);
    else if (high < 6.0 && low > 0.301)
      RC_ASSERT(depth > low - test::kHalfUnit_m && depth < high + test::kHalfUnit_m);
  }
}

}  // namespace
}  // namespace bslnav
