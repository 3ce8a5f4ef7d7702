#include <bslnav/evaluation/CycleSnapshots.h>
#include <gmock/gmock.h>

namespace bslnav {
namespace {

TEST(SnapshotWindow, IsEightBySixMetresAroundAPointInTheOpen) {
  const MapBounds window = snapshotWindow({1.0, 2.0}, {-20.0, -20.0, 20.0, 20.0});
  EXPECT_DOUBLE_EQ(window.xMin_m, -3.0);
  EXPECT_DOUBLE_EQ(window.xMax_m, 5.0);
  EXPECT_DOUBLE_EQ(window.yMin_m, -1.0);
  EXPECT_DOUBLE_EQ(window.yMax_m, 5.0);
}

TEST(SnapshotWindow, MovesToStayWithinTheLimitsAndKeepsItsSize) {
  const MapBounds window = snapshotWindow({9.5, -19.0}, {-20.0, -20.0, 10.0, 20.0});
  EXPECT_DOUBLE_EQ(window.xMin_m, 2.0);
  EXPECT_DOUBLE_EQ(window.xMax_m, 10.0);
  EXPECT_DOUBLE_EQ(window.yMin_m, -20.0);
  EXPECT_DOUBLE_EQ(window.yMax_m, -14.0);
}

TEST(SnapshotWindow, IsTheLimitsWhereTheseAreSmaller) {
  const MapBounds window = snapshotWindow({0.0, 0.0}, {-1.5, -3.0, 11.0, 2.0});
  EXPECT_DOUBLE_EQ(window.xMin_m, -1.5);
  EXPECT_DOUBLE_EQ(window.xMax_m, 6.5);
  EXPECT_DOUBLE_EQ(window.yMin_m, -3.0);
  EXPECT_DOUBLE_EQ(window.yMax_m, 2.0);
}

}  // namespace
}  // namespace bslnav
