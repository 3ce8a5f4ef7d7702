#pragma once

#include <bslnav/blindspot/PclClusters.h>
#include <bslnav/blindspot/VoxelClusters.h>

namespace bslnav {

/** Finds blind spots behind the nearest clusters of depth points (paper V-B: proposed).
 *
 * Of all images together: voxels → between ground and people's heads → clusters → the nearest one
 * on the left and the nearest on the right → where each ends. */
class DepthClusterDetector {
 public:
  /** @throws Error on parameters that do not go together */
  explicit DepthClusterDetector(const DepthClusterParameters& parameters = {});

  /** At most two blind spots, the left one first; valid until the next call.
   * @param frames of status Ok, in the robot frame of now */
  const std::vector<BlindSpot>& detect(const std::vector<const DepthFrame*>& frames);

  /** What the last call found on the way: voxels after the pass-through with their clusters... */
  const ClusteredCloud& cloud() const { return *cloud_; }
  /** ... and the clusters' boxes. */
  const std::vector<DepthCluster>& clusters() const { return clusters_; }

 private:
  const ClusteredCloud& clusterWithPcl(const std::vector<const DepthFrame*>& frames);

  DepthClusterParameters parameters_;
  VoxelClusters dense_;
  ClusteredCloud pclCloud_;
  const ClusteredCloud* cloud_ = &pclCloud_;
  std::vector<DepthCluster> clusters_;
  std::vector<BlindSpot> blindSpots_;
};

/** Every stage of the pipeline for pictures and export, made with PCL. */
struct DepthStages {
  PointCloud points, voxels;
  ClusteredCloud clustered;  ///< after the pass-through
  std::vector<DepthCluster> clusters;
  int left = -1, right = -1;  ///< the nearest clusters
};
DepthStages depthStages(const std::vector<const DepthFrame*>& frames,
                        const DepthClusterParameters& parameters);

}  // namespace bslnav
