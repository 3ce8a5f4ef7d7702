#include <bslnav/blindspot/ScanJumpDetector.h>
#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CRawlog.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <filesystem>

namespace bslnav {
namespace {

/** All scans of a recording with entries of actions and observations. */
std::vector<PlanarScan> scansOf(const std::string& file) {
  mrpt::io::CFileGZInputStream stream(file);
  auto archive = mrpt::serialization::archiveFrom(stream);
  mrpt::obs::CActionCollection::Ptr actions;
  mrpt::obs::CSensoryFrame::Ptr observations;
  mrpt::obs::CObservation::Ptr single;
  std::size_t entry = 0;
  std::vector<PlanarScan> scans;
  while (mrpt::obs::CRawlog::getActionObservationPairOrObservation(archive, actions, observations,
                                                                   single, entry)) {
    if (!observations) continue;
    for (const auto& observation : *observations)
      if (const auto* scan =
              dynamic_cast<const mrpt::obs::CObservation2DRangeScan*>(observation.get()))
        scans.emplace_back().assign(*scan);
  }
  return scans;
}

/** Beams that are the nearer side of a jump, by comparing every beam that says something with the
 * next such beam. */
std::size_t boundariesOf(const PlanarScan& scan, float threshold_m) {
  std::vector<bool> isBoundary(static_cast<std::size_t>(scan.size()), false);
  for (std::size_t i = 0; i < isBoundary.size(); ++i)
    for (std::size_t j = i + 1; j < isBoundary.size(); ++j) {
      if (scan.beam[i] == PlanarScan::Beam::Dropped) break;
      if (scan.beam[j] == PlanarScan::Beam::Dropped) continue;
      if (std::abs(scan.range_m[i] - scan.range_m[j]) > threshold_m)
        isBoundary[scan.range_m[i] < scan.range_m[j] ? i : j] = true;
      break;
    }
  return static_cast<std::size_t>(std::count(isBoundary.begin(), isBoundary.end(), true));
}

TEST(ScanJumpDetectorData, FindsTheJumpsOfARecordedCorridor) {
  const std::string file = std::string(BSLNAV_SHARED_DATA) +
                           "/laser/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no recording at " << file;
  const std::vector<PlanarScan> scans = scansOf(file);
  ASSERT_GT(scans.size(), 200u);
  ScanJumpDetector detector, skipping({1.0, NoReturn::Skip});
  std::size_t total = 0, totalSkipping = 0;
  for (const PlanarScan& scan : scans) {
    const std::size_t found = detector.detect({scan}).size();
    EXPECT_EQ(found, boundariesOf(scan, 1.0f));
    total += found;
    totalSkipping += skipping.detect({scan}).size();
  }
  // A cluttered corridor has 2 to 32 jumps a scan; the 12 % of invalid beams make more when they
  // count as free view.
  EXPECT_GT(totalSkipping, 2 * scans.size());
  EXPECT_LT(totalSkipping, 32 * scans.size());
  EXPECT_GT(total, totalSkipping);
}

}  // namespace
}  // namespace bslnav
