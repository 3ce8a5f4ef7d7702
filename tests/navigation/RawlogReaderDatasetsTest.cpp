#include <bslnav/navigation/RawlogReader.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace bslnav {
namespace {

/** What a recorded log is known to hold: numbers of its documentation, scans and seconds counted in
 * the file. */
struct Dataset {
  std::string name, file;
  std::size_t frames, entries;
  double duration_s, pathLength_m, unusableBeams_percent, fastest_mps;
};

class RawlogReaderDatasets : public testing::TestWithParam<Dataset> {};

TEST_P(RawlogReaderDatasets, HoldsWhatIsKnownOfIt) {
  const Dataset& known = GetParam();
  if (!std::filesystem::exists(known.file)) GTEST_SKIP() << known.file << " is not here";
  RawlogReader reader(known.file);
  double fastest_mps = 0.0;
  for (SensorFrame frame; reader.next(frame);)
    fastest_mps = std::max(fastest_mps, std::abs(frame.twist.vx));
  const auto& statistics = reader.statistics();
  EXPECT_EQ(statistics.frames, known.frames);
  EXPECT_EQ(statistics.entries, known.entries);
  EXPECT_NEAR(statistics.duration_s, known.duration_s, 0.5);
  EXPECT_NEAR(statistics.pathLength_m, known.pathLength_m, 0.5);
  EXPECT_NEAR(statistics.unusableBeams_percent(), known.unusableBeams_percent, 0.1);
  EXPECT_LT(fastest_mps,
            known.fastest_mps);  // localization_demo has garbage where velocities belong
  EXPECT_TRUE(statistics.hasOdometry);
  EXPECT_FALSE(statistics.truncated);
  EXPECT_TRUE(statistics.clockJumps.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Recorded, RawlogReaderDatasets,
    testing::Values(
        Dataset{"LocalizationDemo", "/usr/share/mrpt/datasets/localization_demo.rawlog", 37, 74,
                9.3, 12.8, 0.58, 2.5},
        Dataset{"TelecomFaculty",
                "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog",
                225, 449, 59.1, 76.4, 11.5, 3.0},
        Dataset{"Fr079", BSLNAV_SHARED_DATA "/laser/fr079_fixed.rawlog", 4934, 9868, 1061.4, 391.6,
                2.1, 1.5},
        Dataset{"MitCsail", BSLNAV_SHARED_DATA "/laser/mit-csail_fixed.rawlog", 1988, 3976, 424.0,
                373.6, 3.3, 3.5}),
    [](const auto& dataset) { return dataset.param.name; });

/** A recorded log of one depth observation and nothing else. */
struct DepthDataset {
  std::string name, file, label;
  bool calibrated;
};

class RawlogReaderDepthDatasets : public testing::TestWithParam<DepthDataset> {};

TEST_P(RawlogReaderDepthDatasets, HoldsOneDepthFrame) {
  const DepthDataset& known = GetParam();
  if (!std::filesystem::exists(known.file)) GTEST_SKIP() << known.file << " is not here";
  RawlogReader reader(known.file);
  SensorFrame frame;
  ASSERT_TRUE(reader.next(frame));
  ASSERT_EQ(frame.depth.size(), 1u);
  EXPECT_TRUE(frame.scans.empty());
  const auto& depth = *frame.depth[0];
  EXPECT_EQ(depth.sensorLabel, known.label);
  EXPECT_EQ(depth.rangeImage.cols(), 640);
  EXPECT_EQ(depth.rangeImage.rows(), 480);
  EXPECT_EQ(depth.cameraParams.fx() > 0.0, known.calibrated);
  const auto* pixels = depth.rangeImage.data();
  EXPECT_GT(*std::max_element(pixels, pixels + depth.rangeImage.size()), 0);
  EXPECT_FALSE(reader.next(frame));
  EXPECT_EQ(reader.statistics().depthFrames, 1u);
  EXPECT_EQ(reader.statistics().droppedDepthFrames, 0u);
  EXPECT_FALSE(reader.statistics().truncated);
}

INSTANTIATE_TEST_SUITE_P(
    Recorded, RawlogReaderDepthDatasets,
    testing::Values(DepthDataset{"FivePeople", BSLNAV_SHARED_DATA "/depth/five_people_depth.rawlog",
                                 "DEPTH", true},
                    DepthDataset{"TestsRgbd", BSLNAV_SHARED_DATA "/depth/tests_rgbd.rawlog",
                                 "OPENNI2", true}),
    [](const auto& dataset) { return dataset.param.name; });

}  // namespace
}  // namespace bslnav
