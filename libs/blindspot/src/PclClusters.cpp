#include <bslnav/blindspot/PclClusters.h>
#include <pcl/filters/passthrough.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>

#include <cmath>

namespace bslnav {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr toPcl(const PointCloud& points) {
  auto cloud = pcl::make_shared<Cloud>();
  cloud->reserve(points.size());
  for (const auto& p : points) cloud->push_back({p.x, p.y, p.z});
  return cloud;
}

PointCloud fromPcl(const Cloud& cloud) {
  PointCloud points;
  points.reserve(cloud.size());
  for (const auto& p : cloud) points.emplace_back(p.x, p.y, p.z);
  return points;
}

}  // namespace

PointCloud voxelGrid(const PointCloud& points, double leaf_m, int fewestPoints) {
  if (points.empty()) return {};
  pcl::VoxelGrid<pcl::PointXYZ> filter;
  const auto leaf = static_cast<float>(leaf_m);
  filter.setLeafSize(leaf, leaf, leaf);
  filter.setMinimumPointsNumberPerVoxel(static_cast<unsigned>(fewestPoints));
  filter.setInputCloud(toPcl(points));
  Cloud voxels;
  filter.filter(voxels);
  return fromPcl(voxels);
}

PointCloud passThrough(const PointCloud& points, double zMin_m, double zMax_m) {
  if (points.empty()) return {};
  pcl::PassThrough<pcl::PointXYZ> filter;
  filter.setFilterFieldName("z");
  filter.setFilterLimits(static_cast<float>(zMin_m), static_cast<float>(zMax_m));
  filter.setInputCloud(toPcl(points));
  Cloud kept;
  filter.filter(kept);
  return fromPcl(kept);
}

ClusteredCloud euclideanClusters(const PointCloud& points, double tolerance_m, int fewestPoints) {
  ClusteredCloud clustered{points, std::vector<int>(points.size(), -1), 0};
  if (points.empty()) return clustered;
  const auto cloud = toPcl(points);
  const auto tree = pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>();
  tree->setInputCloud(cloud);
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setClusterTolerance(tolerance_m);
  extraction.setMinClusterSize(fewestPoints);
  extraction.setSearchMethod(tree);
  extraction.setInputCloud(cloud);
  std::vector<pcl::PointIndices> found;
  extraction.extract(found);
  clustered.clusters = static_cast<int>(found.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const auto point : found[i].indices)
      clustered.cluster[static_cast<std::size_t>(point)] = static_cast<int>(i);
  return clustered;
}

PointCloud within(const PointCloud& points, double reach_m) {
  PointCloud kept;
  for (const auto& p : points)
    if (std::abs(p.x) < reach_m && std::abs(p.y) < reach_m) kept.push_back(p);
  return kept;
}

}  // namespace bslnav
