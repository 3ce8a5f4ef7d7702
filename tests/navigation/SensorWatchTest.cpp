#include <bslnav/navigation/SensorWatch.h>
#include <gtest/gtest.h>

#include <cmath>

namespace bslnav {
namespace {

TEST(SensorWatch, HasNoAgeBeforeTheFirstMeasurement) {
  EXPECT_TRUE(std::isinf(SensorWatch().oldestAge_s(0.0)));
}

TEST(SensorWatch, NoticesOneSilentSensorWhileAnotherGoesOn) {
  SensorWatch watch;
  watch.heard(SensorKind::Laser, "front", 1.0, 1.0);
  watch.heard(SensorKind::Laser, "rear", 1.0, 1.0);
  watch.heard(SensorKind::Laser, "front", 2.0, 2.0);
  EXPECT_DOUBLE_EQ(watch.oldestAge_s(2.5), 1.5);  // the rear one
}

TEST(SensorWatch, AnExpectedSensorThatNeverDeliversStaysInfinitelyOld) {
  SensorWatch watch;
  watch.expect(SensorKind::Laser, "front");
  watch.expect(SensorKind::Laser, "rear");
  watch.heard(SensorKind::Laser, "front", 1.0, 1.0);
  EXPECT_TRUE(std::isinf(watch.oldestAge_s(1.0)));
  watch.heard(SensorKind::Laser, "rear", 1.0, 1.0);
  EXPECT_DOUBLE_EQ(watch.oldestAge_s(1.5), 0.5);
}

TEST(SensorWatch, AStampAheadCountsAsNow) {
  SensorWatch watch;
  watch.heard(SensorKind::Laser, "front", 100.0, 1.0);
  EXPECT_DOUBLE_EQ(watch.oldestAge_s(3.0), 2.0);
}

TEST(SensorWatch, AnOlderMeasurementDoesNotMakeASensorOlder) {
  SensorWatch watch;
  watch.heard(SensorKind::Laser, "front", 2.0, 2.0);
  watch.heard(SensorKind::Laser, "front", 1.0, 2.1);
  EXPECT_NEAR(watch.oldestAge_s(2.5), 0.5, 1e-12);
}

}  // namespace
TEST(SensorWatch, TellsApartALaserAndACameraOfOneName) {
  SensorWatch watch;
  watch.expect(SensorKind::Laser, "front");
  watch.expect(SensorKind::Camera, "front");
  watch.heard(SensorKind::Laser, "front", 1.0, 1.0);
  EXPECT_TRUE(std::isinf(watch.oldestAge_s(1.0)));
  EXPECT_EQ(watch.oldest(), "camera 'front'");
  watch.heard(SensorKind::Camera, "front", 1.2, 1.2);
  EXPECT_NEAR(watch.oldestAge_s(1.3), 0.3, 1e-12);
  EXPECT_EQ(watch.oldest(), "laser 'front'");
}

}  // namespace bslnav
