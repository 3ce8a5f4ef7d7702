#include <bslnav/blindspot/DepthClusterDetector.h>

namespace bslnav {
namespace {

DepthClusterParameters checked(const DepthClusterParameters& parameters) {
  parameters.check();
  return parameters;
}

/** Parameters that VoxelClusters can be made with, also when PCL is to do the work. */
DepthClusterParameters forDense(DepthClusterParameters parameters) {
  return parameters.engine == DepthClusterParameters::Engine::Dense ? parameters
                                                                    : DepthClusterParameters{};
}

PointCloud pointsOf(const std::vector<const DepthFrame*>& frames, double reach_m) {
  PointCloud points;
  for (const DepthFrame* frame : frames) {
    const PointCloud more = frame->points();
    points.insert(points.end(), more.begin(), more.end());
  }
  return within(points, reach_m);
}

}  // namespace

DepthClusterDetector::DepthClusterDetector(const DepthClusterParameters& parameters)
    : parameters_(checked(parameters)), dense_(forDense(parameters)) {}

const std::vector<BlindSpot>& DepthClusterDetector::detect(
    const std::vector<const DepthFrame*>& frames) {
  cloud_ = parameters_.engine == DepthClusterParameters::Engine::Dense ? &dense_.cluster(frames)
                                                                       : &clusterWithPcl(frames);
  boxesOf(*cloud_, clusters_);
  blindSpots_.clear();
  for (const bool left : {true, false}) {
    const int nearest = nearestCluster(clusters_, left);
    if (nearest >= 0)
      blindSpots_.push_back(clusters_[static_cast<std::size_t>(nearest)].boundary());
  }
  return blindSpots_;
}

const ClusteredCloud& DepthClusterDetector::clusterWithPcl(
    const std::vector<const DepthFrame*>& frames) {
  pclCloud_ = depthStages(frames, parameters_).clustered;
  return pclCloud_;
}

DepthStages depthStages(const std::vector<const DepthFrame*>& frames,
                        const DepthClusterParameters& p) {
  DepthStages stages;
  stages.points = pointsOf(frames, p.reach() * p.leaf_m);
  stages.voxels = voxelGrid(stages.points, p.leaf_m, p.fewestPoints);
  stages.clustered = euclideanClusters(passThrough(stages.voxels, p.zMin_m, p.zMax_m),
                                       p.tolerance_m, p.fewestVoxels);
  boxesOf(stages.clustered, stages.clusters);
  stages.left = nearestCluster(stages.clusters, true);
  stages.right = nearestCluster(stages.clusters, false);
  return stages;
}

}  // namespace bslnav
