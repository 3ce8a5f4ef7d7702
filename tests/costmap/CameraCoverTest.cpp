#include <bslnav/costmap/CameraCover.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "../support/DepthScene.h"

namespace bslnav {
namespace {

constexpr double kWithin_m = 0.5;

/** A laser that sees all around, half a degree a beam. @param range_m of a bearing in radians; 0:
 * no return */
PlanarScan scanOf(const std::function<double(double)>& range_m) {
  mrpt::obs::CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(2.0 * M_PI);
  scan.maxRange = 10.0f;
  scan.resizeScan(721);
  for (std::size_t i = 0; i < 721; ++i) {
    const double range = range_m(-M_PI + 2.0 * M_PI * static_cast<double>(i) / 720.0);
    scan.setScanRange(i, static_cast<float>(range));
    scan.setScanRangeValidity(i, range != 0.0);
  }
  PlanarScan planar;
  planar.assign(scan, 0.0, {});
  return planar;
}

/** A wall at a distance in a direction. */
PlanarScan wallAt(double distance_m, double direction) {
  return scanOf([=](double bearing) {
    const double cosine = std::cos(bearing - direction);
    return cosine > 0.05 ? distance_m / cosine : 0.0;
  });
}

/** Of a camera at the robot's centre that looks in a direction and sees nothing. */
DepthFrame frameOf(double yaw) {
  auto image = test::DepthScene{{}, 0.0}.picture(test::cameraAt(0.6, 0.1, yaw), 160, 120);
  image.rangeImage.fill(0);
  DepthFrame frame;
  frame.assign(image);
  return frame;
}

TEST(CameraCover, AWallRightBeforeTheCameraCoversItsView) {
  for (const double yaw : {0.0, 1.5, -2.5}) {
    EXPECT_TRUE(isViewCovered(frameOf(yaw), {wallAt(0.3, yaw)}, kWithin_m)) << yaw;
    EXPECT_FALSE(isViewCovered(frameOf(yaw), {wallAt(0.9, yaw)}, kWithin_m)) << yaw;
    EXPECT_FALSE(isViewCovered(frameOf(yaw), {wallAt(0.3, yaw + M_PI)}, kWithin_m)) << yaw;
  }
  EXPECT_FALSE(isViewCovered(frameOf(0.0), {}, kWithin_m));
}

/** What is beside it would be seen. */
TEST(CameraCover, APoleDoesNot) {
  const auto pole = [](double beyond_m) {
    return scanOf([=](double bearing) { return std::abs(bearing) < 0.1 ? 0.3 : beyond_m; });
  };
  EXPECT_FALSE(isViewCovered(frameOf(0.0), {pole(0.0)}, kWithin_m));
  EXPECT_FALSE(isViewCovered(frameOf(0.0), {pole(3.0)}, kWithin_m));
}

TEST(CameraCover, NorDoesTheWallBesideADoor) {
  const PlanarScan door = scanOf([](double bearing) {
    return std::abs(bearing) > 1.5 ? 0.0 : bearing > 0.3 ? 3.0 : 0.3 / std::cos(bearing);
  });
  EXPECT_FALSE(isViewCovered(frameOf(0.0), {door}, kWithin_m));
}

/** It sees through between the bars. */
TEST(CameraCover, NorDoesARailing) {
  const PlanarScan railing = scanOf([](double bearing) {
    const bool isBar = std::fmod(std::abs(bearing), 0.1) < 0.03;
    return std::abs(bearing) < 1.5 && isBar ? 0.3 / std::cos(bearing) : 0.0;
  });
  EXPECT_FALSE(isViewCovered(frameOf(0.0), {railing}, kWithin_m));
}

}  // namespace
}  // namespace bslnav
