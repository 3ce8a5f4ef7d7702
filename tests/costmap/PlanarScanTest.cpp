#include <bslnav/costmap/PlanarScan.h>
#include <gtest/gtest.h>

#include <limits>

#include "CostmapTestTools.h"

namespace bslnav {
namespace {

using Beam = PlanarScan::Beam;

TEST(PlanarScan, TellsHitsFromBeamsWithoutReturnAndBadOnes) {
  const auto scan = test::makeScan(
      {2.0, -1.0, std::nan(""), 0.0, 31.0, std::numeric_limits<double>::infinity()}, 1.0);
  EXPECT_EQ(scan.beam, (std::vector<Beam>{Beam::Hit, Beam::NoReturn, Beam::Dropped, Beam::Dropped,
                                          Beam::NoReturn, Beam::Dropped}));
  EXPECT_EQ(scan.hits(), 1);
  EXPECT_EQ(scan.dropped(), 3);
}

TEST(PlanarScan, DirectionsIncludeTheMountingAngle) {
  const auto scan =
      test::makeScan({1.0, 1.0}, test::kPi, mrpt::poses::CPose3D(0, 0, 0, test::kPi / 2, 0, 0));
  // From -90° to 90° about the sensor's axis, which points to 90°: 0° and 180°.
  EXPECT_NEAR(scan.cosine[0], 1.0, 1e-6);
  EXPECT_NEAR(scan.cosine[1], -1.0, 1e-6);
}

TEST(PlanarScan, UpsideDownSensorRunsTheOtherWay) {
  const auto scan =
      test::makeScan({1.0, 2.0}, test::kPi, mrpt::poses::CPose3D(0, 0, 0.3, 0, 0, test::kPi));
  EXPECT_NEAR(scan.sine[0], -1.0, 1e-6);
  EXPECT_EQ(scan.range_m[0], 2.0f);  // the sensor's last beam is the robot's rightmost
}

TEST(PlanarScan, ShorterRangeLimitMakesBeamsWithoutReturn) {
  mrpt::obs::CObservation2DRangeScan observation;
  observation.maxRange = 30.0f;
  observation.resizeScanAndAssign(1, 4.0f, true);
  PlanarScan scan;
  scan.assign(observation, 3.5);
  EXPECT_EQ(scan.beam[0], Beam::NoReturn);
  EXPECT_FLOAT_EQ(scan.range_m[0], 3.5f);
}

}  // namespace
}  // namespace bslnav
