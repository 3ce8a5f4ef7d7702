#include <bslnav/blindspot/ScanJumpDetector.h>
#include <bslnav/config/Config.h>
#include <gmock/gmock.h>

#include "ScanFixture.h"

namespace bslnav {
namespace {

using test::kLost;
using test::kNone;
using test::scanOf;
using testing::ElementsAre;
using testing::FloatNear;
using testing::IsEmpty;

/** Ranges of the blind spots from the robot's centre, in their order. */
std::vector<float> foundIn(const PlanarScan& scan, const ScanJumpParameters& parameters = {}) {
  ScanJumpDetector detector(parameters);
  std::vector<float> ranges;
  for (const BlindSpot& blindSpot : detector.detect({scan}))
    ranges.push_back(static_cast<float>(blindSpot.range_m));
  return ranges;
}

constexpr ScanJumpParameters kSkip{1.0, NoReturn::Skip};

TEST(ScanJumpDetector, TakesTheNearerBeamOfAJump) {
  EXPECT_THAT(foundIn(scanOf({2, 2, 5, 5})), ElementsAre(FloatNear(2, 1e-6f)));
  EXPECT_THAT(foundIn(scanOf({5, 5, 3, 3})), ElementsAre(FloatNear(3, 1e-6f)));
}

TEST(ScanJumpDetector, NeedsMoreThanTheThreshold) {
  EXPECT_THAT(foundIn(scanOf({2.0f, 3.0f})), IsEmpty());  // exactly 1 m is not more than 1 m
  EXPECT_THAT(foundIn(scanOf({2.0f, 3.01f})), ElementsAre(FloatNear(2, 1e-6f)));
  EXPECT_THAT(foundIn(scanOf({2.0f, 3.01f}), {1.5}), IsEmpty());
}

TEST(ScanJumpDetector, ComparesNeighboursOnly) {
  EXPECT_THAT(foundIn(scanOf({2.0f, 2.9f, 3.8f, 4.7f})), IsEmpty());  // a slanted wall
}

TEST(ScanJumpDetector, FindsBothEdgesOfAnObstacle) {
  EXPECT_THAT(foundIn(scanOf({6, 2.1f, 2.2f, 6})),
              ElementsAre(FloatNear(2.1f, 1e-6f), FloatNear(2.2f, 1e-6f)));
}

TEST(ScanJumpDetector, CountsAPoleOfOneBeamOnce) {
  EXPECT_THAT(foundIn(scanOf({6, 2, 6})), ElementsAre(FloatNear(2, 1e-6f)));
}

TEST(ScanJumpDetector, SeesUpToTheMaximumRangeWithoutReturn) {
  EXPECT_THAT(foundIn(scanOf({4, 4, kNone})), ElementsAre(FloatNear(4, 1e-6f)));
  EXPECT_THAT(foundIn(scanOf({9.5f, kNone})), IsEmpty());  // 0.5 m short of the maximum
}

TEST(ScanJumpDetector, MakesNoJumpAtOrAcrossASkippedBeam) {
  EXPECT_THAT(foundIn(scanOf({4, kNone}), kSkip), IsEmpty());
  EXPECT_THAT(foundIn(scanOf({2, kNone, 6}), kSkip), IsEmpty());
  EXPECT_THAT(foundIn(scanOf({2, kNone, kLost, 6}), kSkip), IsEmpty());
  EXPECT_THAT(foundIn(scanOf({kNone, 3, 6}), kSkip), ElementsAre(FloatNear(3, 1e-6f)));
}

TEST(ScanJumpDetector, NeverJumpsAtADroppedBeam) {
  EXPECT_THAT(foundIn(scanOf({4, kLost, 4, 0, 4})), IsEmpty());
}

TEST(ScanJumpDetector, ComparesTheNeighboursOfDroppedBeams) {
  EXPECT_THAT(foundIn(scanOf({2, kLost, kLost, 6})), ElementsAre(FloatNear(2, 1e-6f)));
}

TEST(ScanJumpDetector, ClosesAFullCircle) {
  const double step = M_PI / 2, full = 3 * step;  // four beams at right angles
  EXPECT_THAT(foundIn(scanOf({2, 2.1f, 2.2f, 6}, full)),
              ElementsAre(FloatNear(2.2f, 1e-6f), FloatNear(2, 1e-6f)));
  EXPECT_THAT(foundIn(scanOf({2, 2.1f, 2.2f, 6}, M_PI)), ElementsAre(FloatNear(2.2f, 1e-6f)));
  EXPECT_THAT(foundIn(scanOf({kLost, 2, 2, 6}, full)),
              ElementsAre(FloatNear(2, 1e-6f), FloatNear(2, 1e-6f)));
}

TEST(ScanJumpDetector, CountsAPoleAtTheSeamOfACircleOnce) {
  EXPECT_THAT(foundIn(scanOf({2, 6, 6, 6}, 1.5 * M_PI)), ElementsAre(FloatNear(2, 1e-6f)));
  EXPECT_THAT(foundIn(scanOf({6, 6, 6, 2}, 1.5 * M_PI)), ElementsAre(FloatNear(2, 1e-6f)));
}

TEST(ScanJumpDetector, GivesPositionsInTheRobotFrame) {
  // Beams at −90°, 0°, +90° of a sensor at (0.3, 0.1) that looks left (yaw 90°): robot frame
  // directions 0°, 90°, 180°. The jump is between the first two; P^b = (0.3 + 2, 0.1).
  ScanJumpDetector detector;
  const auto& found = detector.detect({scanOf({2, 6, 6}, M_PI, {0.3, 0.1, M_PI / 2})});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].position.x, 2.3, 1e-6);
  EXPECT_NEAR(found[0].position.y, 0.1, 1e-6);
  EXPECT_NEAR(found[0].bearing_rad, std::atan2(0.1, 2.3), 1e-6);
  EXPECT_NEAR(found[0].range_m, std::hypot(2.3, 0.1), 1e-6);
}

TEST(ScanJumpDetector, TakesScansOneByOneAndForgetsThemAfterwards) {
  ScanJumpDetector detector;
  EXPECT_EQ(detector.detect({scanOf({2, 2}), scanOf({5, 5})}).size(),
            0u);  // no jump from scan to scan
  EXPECT_EQ(detector.detect({scanOf({2, 5}), scanOf({5, 3})}).size(), 2u);
  EXPECT_EQ(detector.detect({scanOf({2, 5})}).size(), 1u);
  EXPECT_THAT(detector.detect({scanOf({}), scanOf({3}), scanOf({kLost, kLost, kLost})}), IsEmpty());
}

TEST(ScanJumpParameters, LoadFromTheConfiguration) {
  ScanJumpParameters parameters;
  Config config;
  config.bind("scan_jumps", "blind spots from scans", parameters);
  config.load({}, {"scan_jumps.threshold_m=0.7", "scan_jumps.no_return=skip"});
  EXPECT_EQ(parameters.threshold_m, 0.7);
  EXPECT_EQ(parameters.noReturn, NoReturn::Skip);
}

}  // namespace
}  // namespace bslnav
