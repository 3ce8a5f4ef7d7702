#include <bslnav/costmap/DepthFrame.h>
#include <gmock/gmock.h>

#include <limits>

#include "../support/DepthScene.h"

namespace bslnav {
namespace {

using mrpt::obs::CObservation3DRangeScan;
using test::cameraAt;
using test::DepthScene;
using test::SceneBox;
using Status = DepthFrame::Status;

constexpr double kPi = 3.14159265358979;
const SceneBox kWall{3.0, 3.2, -9.0, 9.0, 0.0, 3.0};

DepthFrame frameOf(const CObservation3DRangeScan& image,
                   const mrpt::math::TPose2D& robotFromThen = {}) {
  DepthFrame frame;
  frame.assign(image, robotFromThen);
  return frame;
}

TEST(DepthFrame, PutsPixelsWhereTheirRaysMeetSurfaces) {
  // f = 40 pixels: column 0 looks 39.5/40 to the left per metre ahead, the wall is 3 m ahead.
  const DepthFrame frame = frameOf(DepthScene{{kWall}, 0.0}.picture(cameraAt(0.6)));
  ASSERT_EQ(frame.status(), Status::Ok);
  const auto p = frame.point(0, 29);  // just above the middle row: 0.5/40 up
  EXPECT_NEAR(p.x, 3.0, 1e-3);
  EXPECT_NEAR(p.y, 3.0 * 39.5 / 40.0, 2e-3);
  EXPECT_NEAR(p.z, 0.6 + 3.0 * 0.5 / 40.0, 1e-3);
}

TEST(DepthFrame, PutsTheFloorAtHeightZeroWhateverTheCamerasTilt) {
  for (const double pitch : {0.0, 0.2, 0.6})
    for (const double roll : {0.0, 0.1, kPi}) {  // upside down, and known to be
      const mrpt::poses::CPose3D pose(0.1, 0.2, 0.9, 0.3, pitch, roll);
      const DepthFrame frame = frameOf(DepthScene{}.picture(pose));
      ASSERT_EQ(frame.status(), Status::Ok) << pitch << " " << roll;
      for (const auto& p : frame.points()) EXPECT_NEAR(p.z, 0.0, 2e-3);
    }
}

TEST(DepthFrame, MovesWithTheRobotSinceThePicture) {
  const auto image = DepthScene{{kWall}, 0.0}.picture(cameraAt(0.6));
  const auto still = frameOf(image).point(20, 20);
  // then: 0.5 m behind where the robot is now, turned to its left by 90 degrees
  const auto moved = frameOf(image, {-0.5, 0.0, kPi / 2}).point(20, 20);
  EXPECT_NEAR(moved.x, -0.5 - static_cast<double>(still.y), 1e-5);
  EXPECT_NEAR(moved.y, static_cast<double>(still.x), 1e-5);
  EXPECT_FLOAT_EQ(moved.z, still.z);
}

TEST(DepthFrame, TakesRangesAlongTheRayToo) {
  auto image = DepthScene{{kWall}, 0.0}.picture(cameraAt(0.6));
  const auto expected = frameOf(image).point(0, 29);
  image.range_is_depth = false;
  const double stretch = std::hypot(1.0, 39.5 / 40.0, 0.5 / 40.0);
  image.rangeImage(29, 0) =
      static_cast<std::uint16_t>(std::lround(image.rangeImage(29, 0) * stretch));
  EXPECT_NEAR((frameOf(image).point(0, 29) - expected).norm(), 0.0, 2e-3);
}

TEST(DepthFrame, DropsDepthsBeyondTheMaximum) {
  auto image = DepthScene{{kWall}, 0.0}.picture(cameraAt(0.6));
  image.maxRange = 2.9f;
  EXPECT_EQ(frameOf(image).depthRow(29)[40], 0.0f);  // the wall
  EXPECT_GT(frameOf(image).depthRow(59)[40], 0.0f);  // the floor
  image.maxRange = 6.0f;
  image.rangeImage(29, 40) = 6000;
  image.rangeImage(29, 41) = 6001;
  EXPECT_NEAR(frameOf(image).depthRow(29)[40], 6.0f, 1e-5f);
  EXPECT_EQ(frameOf(image).depthRow(29)[41], 0.0f);
}

TEST(DepthFrame, SaysWhyAnImageCannotBeUsed) {
  const auto image = DepthScene{{kWall}, 0.0}.picture(cameraAt(0.6));
  EXPECT_EQ(frameOf(CObservation3DRangeScan()).status(), Status::NoImage);
  auto uncalibrated = image;
  uncalibrated.cameraParams.setIntrinsicParamsFromValues(0.0, 0.0, 0.0, 0.0);
  EXPECT_EQ(frameOf(uncalibrated).status(), Status::NoCalibration);
  auto withoutUnits = image;
  withoutUnits.rangeUnits = 0.0f;
  EXPECT_EQ(frameOf(withoutUnits).status(), Status::NoCalibration);
  auto turned = image;
  turned.sensorPose = {0.0, 0.0, 0.6, 0.0, std::numeric_limits<double>::quiet_NaN(), 0.0};
  EXPECT_EQ(frameOf(turned).status(), Status::NoCalibration);
  auto otherSize = image;
  otherSize.cameraParams.ncols = 640;
  EXPECT_EQ(frameOf(otherSize).status(), Status::NoCalibration);
  auto lost = image;
  lost.sensorPose.x(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(frameOf(lost).status(), Status::NoCalibration);
  auto blind = image;
  blind.rangeImage.fill(0);
  EXPECT_EQ(frameOf(blind).status(), Status::NoDepth);
  EXPECT_THAT(describe(frameOf(blind)), testing::HasSubstr("no pixel"));
  EXPECT_EQ(describe(frameOf(image)), "");
}

TEST(DepthFrame, NoticesAFloorAtAnotherHeight) {
  for (const double error_m : {-0.3, 0.3}) {
    auto image = DepthScene{{kWall}, 0.0}.picture(cameraAt(0.6, 0.3));
    image.sensorPose.z(0.6 + error_m);  // where it is said to be
    const DepthFrame frame = frameOf(image);
    EXPECT_EQ(frame.status(), Status::FloorAmiss);
    EXPECT_NEAR(frame.floorHeight_m(), error_m, 0.06);
    EXPECT_THAT(describe(frame), testing::HasSubstr("the camera's pose is wrong"));
  }
}

TEST(DepthFrame, NoticesACameraUpsideDown) {
  auto image = DepthScene{{kWall}, 0.0}.picture({0.0, 0.0, 0.6, 0.0, 0.3, 0.0});
  image.sensorPose = {0.0, 0.0, 0.6, 0.0, -0.3, kPi};  // how it is said to hang
  const DepthFrame frame = frameOf(image);
  EXPECT_EQ(frame.status(), Status::FloorAmiss);
  EXPECT_NEAR(frame.floorHeight_m(), 1.2, 0.06);  // the floor is mirrored at the camera
}

TEST(DepthFrame, NoticesACameraSaidToHangUpsideDownAtEveryPitch) {
  for (const double pitch : {0.0, 0.05, 0.1, 0.1745, 0.3}) {
    auto image = DepthScene{}.picture(cameraAt(0.6, pitch), 160, 120);
    image.sensorPose = {0.0, 0.0, 0.6, 0.0, pitch, kPi};
    const DepthFrame frame = frameOf(image);
    ASSERT_EQ(frame.status(), Status::FloorAmiss) << pitch;
    // A floor point at depth d comes out at 1.2 m - 2 d sin(pitch), at d cos(pitch) and more ahead.
    EXPECT_NEAR(frame.floorHeight_m(), 1.2, 0.15) << pitch;
  }
}

TEST(DepthFrame, NoticesAWrongPitch) {
  auto image = DepthScene{}.picture(cameraAt(0.6, 0.2), 160, 120);
  image.sensorPose = cameraAt(0.6, 0.4);  // the floor seems to fall by 0.2 rad
  const DepthFrame frame = frameOf(image);
  ASSERT_EQ(frame.status(), Status::FloorAmiss);
  EXPECT_NEAR(frame.floorHeight_m(), 0.0, 0.05);
  EXPECT_NEAR(frame.floorTilt_rad(), 0.2, 0.02);
}

TEST(DepthFrame, TakesWallsAndTablesForWhatTheyAre) {
  const DepthScene closeUp{{{0.4, 0.6, -9.0, 9.0, 0.0, 3.0}}, 0.0};
  EXPECT_EQ(frameOf(closeUp.picture(cameraAt(0.6, 0.1))).status(), Status::Ok);
  const DepthScene alongside{{{0.0, 9.0, -9.0, -0.5, 0.0, 3.0}}, 0.0};
  EXPECT_EQ(frameOf(alongside.picture(cameraAt(0.6, 0.1))).status(), Status::Ok);
  const DepthScene table{{{1.0, 2.0, -0.7, 0.7, 0.7, 0.75}}, 0.0};
  EXPECT_EQ(frameOf(table.picture(cameraAt(1.2, 0.3))).status(), Status::Ok);
}

}  // namespace
}  // namespace bslnav
