#include <bslnav/navigation/RawlogReader.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace bslnav
