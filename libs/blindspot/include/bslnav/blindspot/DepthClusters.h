#pragma once

#include <bslnav/blindspot/BlindSpot.h>
#include <bslnav/config/ConfigSection.h>
#include <mrpt/math/TPoint3D.h>

#include <cstdint>
#include <vector>

namespace bslnav {

/** Points in the robot frame [m]. */
using PointCloud = std::vector<mrpt::math::TPoint3Df>;

/** From depth images to clusters (paper V-B). */
struct DepthClusterParameters {
  enum class Engine : std::uint8_t {
    Dense,  ///< VoxelClusters: one pass over the pixels, connected components
    Pcl     ///< PCL's VoxelGrid, PassThrough and EuclideanClusterExtraction: slower, the same
  };

  Engine engine = Engine::Dense;
  double leaf_m = 0.05;       ///< side of a voxel (step 2a)
  int fewestPoints = 1;       ///< a voxel with fewer is noise
  double zMin_m = 0.1;        ///< lower is ground (step 2b)
  double zMax_m = 1.8;        ///< higher is above people
  double tolerance_m = 0.15;  ///< neighbours in a cluster are at most this far apart (step 2c)
  int fewestVoxels = 200;     ///< smaller clusters hide nobody
  double maxRange_m = 6.0;    ///< |x| and |y| of a point are below this, rounded up to whole voxels

  void describe(ConfigSection& section);
  /** @throws Error on values that do not go together. */
  void check() const;
  /** maxRange in voxels, rounded up: voxels are whole. */
  int reach() const;
  /** Heights of a voxel from zMin to zMax. */
  int layers() const;
};

/** Points and the cluster of each of them. */
struct ClusteredCloud {
  PointCloud points;
  std::vector<int> cluster;  ///< of each point: 0 to clusters − 1, or −1 for none
  int clusters = 0;
};

/** A cluster, as its box. */
struct DepthCluster {
  mrpt::math::TPoint3Df lower, upper;  ///< corners, robot frame [m]
  int voxels = 0;
  float distance_m = 0.0f;  ///< of its nearest point from the robot's centre, seen from above

  bool isLeft() const { return lower.y + upper.y > 0.0f; }
  /** Where what is seen of it ends: P^b = (max x, (max y + min y)/2) (paper, eq. 7). */
  BlindSpot boundary() const {
    return BlindSpot::at({upper.x, 0.5 * (static_cast<double>(lower.y) + upper.y)});
  }
};

/** The boxes of all clusters, by number, into `boxes`. */
void boxesOf(const ClusteredCloud& cloud, std::vector<DepthCluster>& boxes);

/** The nearest cluster on a side of the robot, or −1 (step 2d). */
int nearestCluster(const std::vector<DepthCluster>& boxes, bool left);

}  // namespace bslnav
