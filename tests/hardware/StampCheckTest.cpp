#include <bslnav/hardware/StampCheck.h>
#include <gmock/gmock.h>

namespace bslnav {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

mrpt::obs::CObservation2DRangeScan scanOf(float range_m) {
  mrpt::obs::CObservation2DRangeScan scan;
  scan.resizeScanAndAssign(10, range_m, true);
  return scan;
}

TEST(StampCheck, TakesWhatIsNewerThanTheLast) {
  StampCheck check({});
  EXPECT_THAT(check.refusal(1.0, 1.02), IsEmpty());
  EXPECT_THAT(check.refusal(1.1, 1.12), IsEmpty());
  EXPECT_THAT(check.refusal(1.1, 1.22), HasSubstr("before the last one"));
  EXPECT_EQ(check.refused(), 1);
}

TEST(StampCheck, RefusesWhatComesFromTheFuture) {
  StampCheck check({});
  EXPECT_THAT(check.refusal(11.0, 1.0), HasSubstr("its clock is 10.000 s ahead"));
  EXPECT_THAT(check.refusal(1.1, 1.1), IsEmpty());  // that was not the newest
}

/** Real ranges have noise: the same bits again and again are no new scan, whatever their stamps. */
TEST(StampCheck, ALaserThatRepeatsOneScanIsFrozen) {
  StampCheck check({});
  for (int k = 0; k <= 5; ++k)
    EXPECT_THAT(check.refusal(scanOf(2.0f), 0.1 * k + 1.0, 0.1 * k + 1.0), IsEmpty()) << k;
  EXPECT_THAT(check.refusal(scanOf(2.0f), 1.7, 1.7), HasSubstr("repeated one scan for 0.7 s"));
  EXPECT_THAT(check.refusal(scanOf(2.001f), 1.8, 1.8), IsEmpty());
}

TEST(StampCheck, NoLaserIsFrozenWhereThatIsSwitchedOff) {
  StampCheckParameters parameters;
  parameters.frozen_s = 0.0;
  StampCheck check(parameters);
  for (int k = 0; k < 50; ++k) EXPECT_THAT(check.refusal(scanOf(2.0f), k, k), IsEmpty());
}

}  // namespace
}  // namespace bslnav
