#include <bslnav/config/ConfigSection.h>
#include <bslnav/config/Error.h>
#include <bslnav/navigation/LocalizationParticleFilter.h>
#include <bslnav/navigation/RawlogReader.h>
#include <gmock/gmock.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimpleMap.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace bslnav {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPose2D;

const std::string kDatasets = "/usr/share/mrpt/datasets/";

/** Where the robot of localization_demo.rawlog starts: by brute-force search, the pose at which its
 * 361 first end points lie nearest to occupied cells (12 mm on average). */
const TPose2D kInitialPose(3.49, -10.23, -28.7 * M_PI / 180.0);

/** Distance from a point to the nearest occupied cell, at most 0.5 m. */
double distanceToOccupied(const COccupancyGridMap2D& map, double x_m, double y_m) {
  constexpr int kCells = 10;
  const int cx = map.x2idx(x_m), cy = map.y2idx(y_m);
  double nearest = 0.5;
  for (int dy = -kCells; dy <= kCells; ++dy)
    for (int dx = -kCells; dx <= kCells; ++dx) {
      if (map.getCell(cx + dx, cy + dy) >= 0.35f) continue;  // also outside the map: 0.5
      const auto x = static_cast<std::size_t>(cx + dx), y = static_cast<std::size_t>(cy + dy);
      nearest = std::min<double>(nearest, std::hypot(map.idx2x(x) - x_m, map.idx2y(y) - y_m));
    }
  return nearest;
}

double meanDistance(const COccupancyGridMap2D& map, const SensorFrame& frame, const TPose2D& pose) {
  const auto& scan = *frame.scans.at(0);
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < scan.getScanSize(); i += 4) {
    if (!scan.getScanRangeValidity(i)) continue;
    const double angle = scan.getScanAngle(i), range = scan.getScanRange(i);
    const auto end = pose.composePoint({scan.sensorPose.x() + range * std::cos(angle),
                                        scan.sensorPose.y() + range * std::sin(angle)});
    sum += distanceToOccupied(map, end.x, end.y);
    ++count;
  }
  return sum / count;
}

class ParticleFilter : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    mrpt::maps::CSimpleMap recorded;
    if (!recorded.loadFromFile(kDatasets + "localization_demo.simplemap.gz")) return;
    auto map = std::make_shared<COccupancyGridMap2D>();
    map->loadFromSimpleMap(recorded);
    map_ = map;
    RawlogReader log(kDatasets + "localization_demo.rawlog");
    for (SensorFrame frame; log.next(frame);) frames_.push_back(frame);
  }
  static void TearDownTestSuite() {
    map_.reset();
    frames_.clear();
  }
  void SetUp() override {
    if (!map_) GTEST_SKIP() << kDatasets << " is not here";
  }

  std::vector<TPose2D> localize(const TPose2D& initialPose, std::uint32_t seed) {
    ParticleFilterLocalization localization(parameters_, map_, initialPose, seed);
    std::vector<TPose2D> poses;
    for (const auto& frame : frames_) poses.push_back(localization.update(frame));
    spread_m_ = localization.spread_m();
    return poses;
  }

  static std::shared_ptr<const COccupancyGridMap2D> map_;
  static std::vector<SensorFrame> frames_;
  ParticleFilterParameters parameters_;
  double spread_m_ = 0.0;
};
std::shared_ptr<const COccupancyGridMap2D> ParticleFilter::map_;
std::vector<SensorFrame> ParticleFilter::frames_;

TEST_F(ParticleFilter, KeepsEveryScanOnTheMap) {
  const auto poses = localize(kInitialPose, 1);
  for (std::size_t i = 0; i < poses.size(); ++i)
    EXPECT_LT(meanDistance(*map_, frames_[i], poses[i]), 0.15) << i;
  EXPECT_LT(spread_m_, 0.1);
}

TEST_F(ParticleFilter, DoesWhatOdometryAloneDoesNot) {
  OdometryLocalization odometry(kInitialPose);
  TPose2D pose;
  for (const auto& frame : frames_) pose = odometry.update(frame);
  EXPECT_GT(meanDistance(*map_, frames_.back(), pose), 0.15);
}

TEST_F(ParticleFilter, RecoversFromAnInitialPoseThatIsSomewhatWrong) {
  const auto poses = localize(kInitialPose + TPose2D(0.2, -0.2, 0.08), 1);
  EXPECT_LT(meanDistance(*map_, frames_.back(), poses.back()), 0.15);
}

TEST_F(ParticleFilter, WorksWithRayTracing) {
  parameters_.likelihood = ParticleFilterParameters::Likelihood::RayTracing;
  parameters_.beamDecimation = 10;
  const auto poses = localize(kInitialPose, 1);
  EXPECT_LT(meanDistance(*map_, frames_.back(), poses.back()), 0.15);
}

TEST_F(ParticleFilter, GivesTheSamePosesForTheSameSeed) {
  EXPECT_EQ(localize(kInitialPose, 7), localize(kInitialPose, 7));
}

TEST_F(ParticleFilter, GivesSlightlyDifferentPosesForAnotherSeed) {
  const auto one = localize(kInitialPose, 7), other = localize(kInitialPose, 8);
  EXPECT_NE(one, other);
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_LT(std::hypot(one[i].x - other[i].x, one[i].y - other[i].y), 0.2) << i;
}

TEST_F(ParticleFilter, PredictsNoMotionOverAGap) {
  // The odometry jumps by 5 m; without scans only the prediction could move the pose.
  ParticleFilterLocalization localization(parameters_, map_, kInitialPose, 1);
  SensorFrame frame;
  const TPose2D before = localization.update(frame);
  frame.odometry.x = 5.0;
  frame.afterGap = true;
  EXPECT_EQ(localization.update(frame), before);
  frame.odometry.x = 6.0;
  frame.afterGap = false;
  const TPose2D after =
      localization.update(frame);  // 1 m ahead; noise 6 cm a particle, 3 mm for the mean of 500
  EXPECT_NEAR(std::hypot(after.x - before.x, after.y - before.y), 1.0, 0.03);
}

TEST_F(ParticleFilter, StartsWithTheSpreadItIsGiven) {
  // Uniform up to ±0.3 m in x and y: the standard deviation of each is 0.3 / √3, of both √2 times
  // that, 0.245 m.
  ParticleFilterLocalization localization(parameters_, map_, kInitialPose, 1);
  localization.update(SensorFrame{});
  EXPECT_NEAR(localization.spread_m(), 0.245, 0.02);
}

TEST_F(ParticleFilter, PaysNoAttentionToBeamsThatSayNothing) {
  // Every third range becomes NaN, zero or negative, and valid.
  const float bad[] = {std::numeric_limits<float>::quiet_NaN(), 0.0f, -1.0f,
                       std::numeric_limits<float>::infinity()};
  ParticleFilterLocalization localization(parameters_, map_, kInitialPose, 1);
  TPose2D pose;
  for (auto frame : frames_) {
    auto scan = std::make_shared<mrpt::obs::CObservation2DRangeScan>(*frame.scans[0]);
    for (std::size_t i = 0; i < scan->getScanSize(); i += 3) {
      scan->setScanRange(i, bad[i / 3 % 4]);
      scan->setScanRangeValidity(i, true);
    }
    frame.scans = {scan};
    pose = localization.update(frame);
  }
  EXPECT_LT(meanDistance(*map_, frames_.back(), pose), 0.15);
}

TEST_F(ParticleFilter, PassesOverScansOfLessThanTwoBeams) {
  parameters_.likelihood = ParticleFilterParameters::Likelihood::RayTracing;
  ParticleFilterLocalization localization(parameters_, map_, kInitialPose, 1);
  SensorFrame frame;
  const TPose2D before = localization.update(frame);
  auto scan = std::make_shared<mrpt::obs::CObservation2DRangeScan>();
  for (const std::size_t beams : {0, 1}) {
    scan->resizeScanAndAssign(beams, 2.0f, true);
    frame.scans = {scan};
    frame.afterGap = true;  // so that nothing but the scan could move the pose
    EXPECT_EQ(localization.update(frame), before);
  }
}

TEST_F(ParticleFilter, PredictsOverFramesThatHoldDepthOnly) {
  // 1 m ahead in five frames without any scan; noise as above, and 1 cm of every frame.
  ParticleFilterLocalization localization(parameters_, map_, kInitialPose, 1);
  SensorFrame frame;
  frame.depth = {std::make_shared<mrpt::obs::CObservation3DRangeScan>()};
  const TPose2D before = localization.update(frame);
  const double spread_m = localization.spread_m();
  TPose2D after;
  for (int i = 1; i <= 5; ++i) {
    frame.odometry.x = 0.2 * i;
    after = localization.update(frame);
  }
  EXPECT_NEAR(std::hypot(after.x - before.x, after.y - before.y), 1.0, 0.03);
  EXPECT_GT(localization.spread_m(), spread_m);
}

TEST_F(ParticleFilter, RefusesAnInitialPoseOutsideTheMap) {
  EXPECT_THROW(ParticleFilterLocalization(parameters_, map_, {1000, 0, 0}, 1), Error);
}

TEST(ParticleFilterParameters, ReadsItsKeysInTheirUnits) {
  ParticleFilterParameters parameters;
  ConfigSection section("localization", "");
  parameters.describe(section);
  for (const auto& field : section.fields()) {
    if (field.key == "initial_spread_deg") field.read("90");
    if (field.key == "likelihood") field.read("ray_tracing");
  }
  EXPECT_DOUBLE_EQ(parameters.initialSpread_rad, M_PI / 2);
  EXPECT_EQ(parameters.likelihood, ParticleFilterParameters::Likelihood::RayTracing);
}

}  // namespace
}  // namespace bslnav
