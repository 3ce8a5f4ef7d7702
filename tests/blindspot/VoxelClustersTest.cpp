#include <bslnav/blindspot/DepthClusterDetector.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "../support/DepthScene.h"
#include "../support/HeapUse.h"

namespace bslnav {
namespace {

using test::DepthScene;
using test::SceneBox;

constexpr float kRounding_m = 1e-4f;  // of centroids: PCL adds up the points in another order

/** For each point of `a` the index of the same point of `b`; −1 where there is none. */
std::vector<int> matches(const PointCloud& a, const PointCloud& b) {
  std::vector<int> match(a.size(), -1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if ((a[i] - b[j]).sqrNorm() < kRounding_m * kRounding_m) match[i] = static_cast<int>(j);
  return match;
}

/** Whether two clouds with the same points are parted in the same way, whatever the numbers. */
bool isSamePartition(const ClusteredCloud& a, const ClusteredCloud& b,
                     const std::vector<int>& match) {
  std::map<int, int> nameInB{{-1, -1}};
  for (std::size_t i = 0; i < match.size(); ++i) {
    const int other = b.cluster[static_cast<std::size_t>(match[i])];
    if (nameInB.emplace(a.cluster[i], other).first->second != other) return false;
  }
  return a.clusters == b.clusters;  // then no two clusters of a are one of b
}

/** Whether some pair of points is as far apart as the tolerance, to within rounding. */
bool isOnTheEdge(const PointCloud& points, double tolerance_m) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      if (std::abs((points[i] - points[j]).norm() - static_cast<float>(tolerance_m)) < 2e-5f)
        return true;
  return false;
}

/** Evenly distributed from the first case on; by itself RapidCheck begins at the lower end. */
int anyFrom(int low, int high) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high));
}

SceneBox anyBox() {
  const auto metres = [](int low, int high) { return anyFrom(low, high) / 100.0; };
  const double x = metres(60, 350), y = metres(-200, 120), z = metres(0, 80);
  return {x, x + metres(5, 150), y, y + metres(5, 150), z, z + metres(5, 180)};
}

DepthClusterParameters fewVoxels() {
  DepthClusterParameters parameters;
  parameters.fewestVoxels = 20;
  return parameters;
}

std::vector<const DepthFrame*> pointersTo(const std::vector<DepthFrame>& frames) {
  std::vector<const DepthFrame*> pointers;
  for (const auto& frame : frames) pointers.push_back(&frame);
  return pointers;
}

RC_GTEST_PROP(VoxelClusters, EqualPcl, ()) {
  DepthScene scene;
  const int count = anyFrom(1, 8);
  for (int i = 0; i < count; ++i) scene.boxes.push_back(anyBox());
  std::vector<DepthFrame> frames(static_cast<std::size_t>(anyFrom(1, 3)));
  for (std::size_t i = 0; i < frames.size(); ++i)
    frames[i].assign(scene.picture(test::cameraAt(anyFrom(30, 150) / 100.0, anyFrom(0, 40) / 100.0,
                                                  static_cast<double>(i) * 0.9)));
  DepthClusterParameters p = fewVoxels();
  p.fewestPoints = anyFrom(1, 4);
  p.fewestVoxels = anyFrom(1, 20);
  p.maxRange_m = anyFrom(200, 600) / 100.0;  // mostly within a voxel
  // Centroids on surfaces in line with the grid are whole leaves apart: no such tolerance.
  p.tolerance_m = anyFrom(1010, 1490) / 10000.0 + 3e-5;
  VoxelClusters dense(p);
  const ClusteredCloud& fast = dense.cluster(pointersTo(frames));
  const DepthStages plain = depthStages(pointersTo(frames), p);
  RC_ASSERT(fast.points.size() == plain.clustered.points.size());
  const auto match = matches(fast.points, plain.clustered.points);
  RC_ASSERT(std::count(match.begin(), match.end(), -1) == 0);
  RC_PRE(!isOnTheEdge(fast.points, p.tolerance_m));  // there, rounding decides
  RC_CLASSIFY(fast.clusters == 0, "no cluster");
  RC_CLASSIFY(fast.clusters > 1, "several clusters");
  RC_ASSERT(isSamePartition(fast, plain.clustered, match));
}

/** A box of 0.4 m x 0.4 m x 1 m, its front 2 m ahead. */
SceneBox boxAt(double y) { return {2.0, 2.4, y - 0.2, y + 0.2, 0.0, 1.0}; }

TEST(VoxelClusters, HaveNothingOfAnEmptyFloor) {
  DepthFrame frame;
  frame.assign(DepthScene{}.picture(test::cameraAt(0.6, 0.3)));
  VoxelClusters clusters(fewVoxels());
  EXPECT_TRUE(clusters.cluster({&frame}).points.empty());
  EXPECT_EQ(clusters.cluster({}).clusters, 0);
}

TEST(VoxelClusters, EndWithTheVoxelThatHoldsTheMaximumRange) {
  DepthFrame frame;
  frame.assign(DepthScene{{{0.9, 2.5, -1.0, -0.8, 0.0, 2.0}}, 0.0}.picture(test::cameraAt(0.6, 0.1),
                                                                           160, 120));
  DepthClusterParameters p = fewVoxels();
  p.maxRange_m = 1.52;  // the last voxel reaches to 1.55 m
  VoxelClusters dense(p);
  const auto& fast = dense.cluster({&frame});
  EXPECT_EQ(fast.points.size(), depthStages({&frame}, p).clustered.points.size());
  for (const auto& point : fast.points) EXPECT_LT(point.x, 1.55f);
}

TEST(VoxelClusters, JoinTheViewsOfTwoCameras) {
  const DepthScene scene{{boxAt(0.9), boxAt(-0.9)}, 0.0};
  DepthFrame left, right;
  left.assign(scene.picture(test::cameraAt(0.6, 0.0, 0.8)));
  right.assign(scene.picture(test::cameraAt(0.6, 0.0, -0.8)));
  VoxelClusters clusters(fewVoxels());
  EXPECT_EQ(clusters.cluster({&left}).clusters, 1);
  EXPECT_EQ(clusters.cluster({&left, &right}).clusters, 2);
}

TEST(VoxelClusters, AllocateNothingTheSecondTime) {
  DepthFrame frame;
  frame.assign(DepthScene{{boxAt(0.5), boxAt(-0.5)}, 0.0}.picture(test::cameraAt(0.6)));
  const std::vector<const DepthFrame*> frames{&frame};
  VoxelClusters clusters(fewVoxels());
  clusters.cluster(frames);
  const auto before = test::heapUse().allocations;
  clusters.cluster(frames);
  EXPECT_EQ(test::heapUse().allocations, before);
}

}  // namespace
}  // namespace bslnav
