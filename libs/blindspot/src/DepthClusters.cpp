#include <bslnav/blindspot/DepthClusters.h>
#include <bslnav/config/Config.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bslnav {
namespace {

constexpr int kMostLayers = 64;  // one bit each in VoxelClusters

int cellOf(double value_m, double leaf_m) { return static_cast<int>(std::floor(value_m / leaf_m)); }

}  // namespace

void DepthClusterParameters::describe(ConfigSection& section) {
  section.choice("engine", engine, {{"dense", Engine::Dense}, {"pcl", Engine::Pcl}},
                 "who makes the clusters: bslnav in one pass, or PCL; both give the same");
  section.number("leaf_m", leaf_m, {0.01, 0.5}, "m", "side of a voxel");
  section.integer("points_per_voxel", fewestPoints, {1, 1000}, "",
                  "a voxel with fewer points is noise");
  section.number("z_min_m", zMin_m, {-1.0, 5.0}, "m", "lower voxels are ground");
  section.number("z_max_m", zMax_m, {0.0, 5.0}, "m", "higher voxels are above people");
  section.number("tolerance_m", tolerance_m, {0.01, 1.0}, "m",
                 "voxels at most this far apart are of one cluster");
  section.integer("voxels_per_cluster", fewestVoxels, {1, 1000000}, "",
                  "a cluster with fewer voxels hides nobody: poles, small boxes");
  section.number("max_range_m", maxRange_m, {0.5, 30.0}, "m",
                 "points farther ahead, behind or aside do not count; rounded up to whole voxels");
}

int DepthClusterParameters::reach() const {
  return static_cast<int>(std::ceil(maxRange_m / leaf_m - 1e-6));
}

int DepthClusterParameters::layers() const {
  return cellOf(zMax_m, leaf_m) - cellOf(zMin_m, leaf_m) + 1;
}

void DepthClusterParameters::check() const {
  if (!(zMax_m > zMin_m)) Config::refuse("depth_clusters", "z_max_m", "a height above z_min_m");
  if (engine != Engine::Dense) return;
  if (layers() > kMostLayers)
    Config::refuse("depth_clusters", "leaf_m",
                   "at most 64 voxels between z_min_m and z_max_m, or engine = pcl");
  if (maxRange_m / leaf_m > 600.0)
    Config::refuse("depth_clusters", "max_range_m", "at most 600 voxels, or engine = pcl");
  if (tolerance_m / leaf_m > 10.0)
    Config::refuse("depth_clusters", "tolerance_m", "at most 10 voxels, or engine = pcl");
}

void boxesOf(const ClusteredCloud& cloud, std::vector<DepthCluster>& boxes) {
  constexpr float kFar = std::numeric_limits<float>::max();
  boxes.assign(static_cast<std::size_t>(cloud.clusters),
               {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}, 0, kFar});
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (cloud.cluster[i] < 0) continue;
    DepthCluster& box = boxes[static_cast<std::size_t>(cloud.cluster[i])];
    const auto& p = cloud.points[i];
    box.lower = {std::min(box.lower.x, p.x), std::min(box.lower.y, p.y),
                 std::min(box.lower.z, p.z)};
    box.upper = {std::max(box.upper.x, p.x), std::max(box.upper.y, p.y),
                 std::max(box.upper.z, p.z)};
    box.distance_m = std::min(box.distance_m, p.x * p.x + p.y * p.y);
    ++box.voxels;
  }
  for (DepthCluster& box : boxes) box.distance_m = std::sqrt(box.distance_m);
}

int nearestCluster(const std::vector<DepthCluster>& boxes, bool left) {
  int nearest = -1;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (boxes[i].isLeft() == left &&
        (nearest < 0 || boxes[i].distance_m < boxes[static_cast<std::size_t>(nearest)].distance_m))
      nearest = static_cast<int>(i);
  return nearest;
}

}  // namespace bslnav
