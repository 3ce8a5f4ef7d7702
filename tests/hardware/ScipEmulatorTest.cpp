#include <ScipEmulator.h>
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "DrivenLaser.h"

namespace bslnav::test {
namespace {

std::vector<float> rangesOf(const mrpt::obs::CObservation2DRangeScan& scan) {
  std::vector<float> ranges_m;
  for (std::size_t i = 0; i < scan.getScanSize(); ++i) ranges_m.push_back(scan.getScanRange(i));
  return ranges_m;
}

/** Walls beside the robot, the left one nearer: faces at y = 0.95 m and y = -1.95 m. */
WorldParameters corridor() {
  WorldParameters world;
  world.walls["left"].points_m = {{-50.0, 1.0}, {50.0, 1.0}};
  world.walls["right"].points_m = {{-50.0, -2.0}, {50.0, -2.0}};
  for (auto& [name, wall] : world.walls) wall.thickness_m = 0.1;
  return world;
}

double seconds(const DrivenLaser::Scan& from, const DrivenLaser::Scan& to) {
  return mrpt::system::timeDifference(from->timestamp, to->timestamp);
}

class EitherModel : public testing::TestWithParam<ScipModel> {};

TEST_P(EitherModel, RangesArriveToTheMillimetre) {
  ScipEmulator emulator(GetParam());
  std::vector<float> ranges_m;
  for (int i = 0; i < GetParam().beams(); ++i)
    ranges_m.push_back(0.5f + 0.0071f * static_cast<float>(i));
  emulator.setRanges(ranges_m);
  DrivenLaser laser(emulator.path());
  const auto scans = laser.scans(1);
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_EQ(scans[0]->sensorLabel, "FRONT");
  EXPECT_NEAR(scans[0]->sensorPose.yaw(), M_PI / 2, 1e-6);
  ASSERT_EQ(scans[0]->getScanSize(), ranges_m.size());
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    const bool seen = ranges_m[i] < 1e-3f * static_cast<float>(GetParam().maxRange_mm);
    ASSERT_EQ(scans[0]->getScanRangeValidity(i), seen) << i;
    if (!seen) continue;
    ASSERT_NEAR(scans[0]->getScanRange(i), ranges_m[i], 0.00051) << i;
  }
  EXPECT_EQ(laser.complaints(), "");
}

// The driver spreads its n beams over n steps instead of the n - 1 that lie between them, and puts
// their middle straight ahead wherever the laser's front step is. Step δ, front step f, first step
// a: beam i is said to look (i / (n - 1) - n / 2 + f - a) δ too far to the left. So from -δ/2 to
// δ/2 = 0.125° for the UTM-30LX, and from -δ = -0.35° to 0 for the URG-04LX.
TEST_P(EitherModel, AnglesAreThoseOfTheWorldButForTheDriversOffset) {
  const auto& model = GetParam();
  LaserSensor sensor("laser", model.simulated(), 1);
  ScipEmulator emulator(model);
  emulator.setRanges(rangesOf(*sensor.scan(RayScene(corridor(), {}), {}, mrpt::Clock::now())));
  DrivenLaser laser(emulator.path());
  const auto scans = laser.scans(1);
  ASSERT_EQ(scans.size(), 1u);
  const double step_rad = 2.0 * M_PI / model.stepsPerTurn, n = model.beams();
  int seen = 0;
  for (int i = 0; i < model.beams(); ++i) {
    const auto beam = static_cast<std::size_t>(i);
    const double angle_rad = model.angle_rad(model.firstStep + i);
    const double offset = i / (n - 1.0) - n / 2.0 + model.frontStep - model.firstStep;
    ASSERT_NEAR(scans[0]->getScanAngle(beam), angle_rad + offset * step_rad, 1e-5) << i;
    if (!scans[0]->getScanRangeValidity(beam)) continue;
    // Rounded to a millimetre, the end of a beam is as near to its wall.
    const double y_m = scans[0]->getScanRange(beam) * std::sin(angle_rad);
    ASSERT_NEAR(y_m, angle_rad > 0.0 ? 0.95 : -1.95, 0.00052) << i;
    ++seen;
  }
  EXPECT_GT(seen, model.beams() / 2);
}

INSTANTIATE_TEST_SUITE_P(ScipEmulator, EitherModel,
                         testing::Values(ScipModel::urg04lx(), ScipModel()),
                         [](const auto& tested) {
                           return tested.param.stepsPerTurn == 1024 ? "Urg04Lx" : "Utm30Lx";
                         });

TEST(ScipEmulator, BeamsWithoutARangeAreInvalid) {
  ScipEmulator emulator;
  std::vector<float> ranges_m(1081, 1.0f);
  ranges_m[0] = std::numeric_limits<float>::infinity();
  ranges_m[1] = std::numeric_limits<float>::quiet_NaN();
  ranges_m[2] = 30.0f;  // the maximum range is out of range
  ranges_m[3] = 0.01f;  // too near
  emulator.setRanges(ranges_m);
  DrivenLaser laser(emulator.path());
  const auto scans = laser.scans(1);
  ASSERT_EQ(scans.size(), 1u);
  for (std::size_t i = 0; i < 1081; ++i) ASSERT_EQ(scans[0]->getScanRangeValidity(i), i > 3) << i;
  EXPECT_FLOAT_EQ(scans[0]->getScanRange(0), 0.001f);  // the error code as it came
}

TEST(ScipEmulator, ScansComeAtTheLasersRateWithItsStamps) {
  ScipEmulator emulator;
  DrivenLaser laser(emulator.path());
  const auto scans = laser.scans(50);
  ASSERT_EQ(scans.size(), 50u);
  // The driver stamps the first ten by itself, and counts on from the eleventh by the laser's
  // clock. Missed turns are whole ones.
  for (std::size_t i = 11; i < scans.size(); ++i) {
    const double periods = seconds(scans[10], scans[i]) / 0.025;
    ASSERT_NEAR(periods, std::round(periods), 1e-3) << i;
    ASSERT_GT(seconds(scans[i - 1], scans[i]), 0.0) << i;
  }
  EXPECT_LT(seconds(scans[10], scans[49]), 2.0 * 39 * 0.025);
  EXPECT_LT(std::abs(mrpt::system::timeDifference(scans[49]->timestamp, mrpt::Clock::now())), 1.0);
}

TEST(ScipEmulator, WithoutTheLasersClockScansAreStampedAsTheyArrive) {
  ScipEmulator emulator;
  DrivenLaser laser(emulator.path(), "disable_firmware_timestamp = true\n");
  laser.scans(20);
  for (int i = 0; i < 10; ++i) {
    const auto before = mrpt::Clock::now();
    const auto scans = laser.scans(1);
    ASSERT_EQ(scans.size(), 1u);
    EXPECT_GE(scans[0]->timestamp, before);
    EXPECT_LE(scans[0]->timestamp, mrpt::Clock::now());
  }
}

TEST(ScipEmulator, ASecondDriverScansWhereTheFirstEnded) {
  ScipEmulator emulator;
  for (int i = 0; i < 2; ++i) {
    DrivenLaser laser(emulator.path());
    EXPECT_EQ(laser.scans(3).size(), 3u);
    EXPECT_EQ(laser.complaints(), "");
  }
}

}  // namespace
}  // namespace bslnav::test
