#pragma once

#include <bslnav/blindspot/DepthClusters.h>
#include <bslnav/costmap/DepthFrame.h>

namespace bslnav {

/** The paper's pipeline on a dense grid: voxels, pass-through and clusters as PCL makes them.
 *
 * One pass over the pixels sums up the points of each voxel, in blocks of one column of voxels;
 * then voxels whose centroids are near enough are joined, found through one bit a voxel. The volume
 * is |x|, |y| < max_range around the robot and z_min to z_max. Centroids are PCL's but for the
 * order of a sum (rounding, below 0.1 mm); a pair of centroids whose distance is that near to the
 * tolerance may be joined here and not there. */
class VoxelClusters {
 public:
  /** @param parameters checked */
  explicit VoxelClusters(const DepthClusterParameters& parameters);

  /** The clusters of all points of these images, all in the robot frame of now. Valid until the
   * next call; allocates nothing once the number of voxels has been at its largest. */
  const ClusteredCloud& cluster(const std::vector<const DepthFrame*>& frames);

 private:
  struct Voxel {
    float x = 0.0f, y = 0.0f, z = 0.0f;  // sums; the centroid later
    int count = 0;                       // of points; the index in cloud_.points later
  };
  struct Offset {
    std::ptrdiff_t column;
    bool adjacent;
  };
  struct Part {  // voxels of a column that are of one cluster, whatever the other columns
    std::size_t block;
    std::uint64_t voxels;  // one bit each
    int point;             // the lowest
  };

  void clear();
  void add(const DepthFrame& frame);
  void addRow(int columns);
  Voxel* voxelAt(int key);
  void keepVoxels();
  const Voxel* voxelsOf(std::size_t block) const {
    return voxels_.data() + block * static_cast<std::size_t>(layers_);
  }
  void connect();
  void addParts(std::size_t block);
  void joinNeighbours(bool adjacent);
  void join(std::size_t block, std::size_t other);
  bool isNear(const Part& part, const Part& other, std::uint64_t voxels) const;
  int rootOf(int point);
  void number();

  DepthClusterParameters parameters_;
  int half_, side_, lowest_, layers_, reach_;  // in voxels
  std::vector<Offset> neighbours_;             // of a column, in one half plane
  std::vector<int> blockOf_;                   // of each column of the volume, or −1
  std::vector<int> columns_;                   // of each block
  std::vector<Voxel> voxels_;                  // layers_ of each block
  std::vector<std::uint64_t> occupied_;        // of each block: one bit a voxel
  std::vector<float> x_, y_, z_;               // of a row of pixels
  std::vector<int> key_;
  std::vector<Part> parts_;             // block by block
  std::vector<std::size_t> firstPart_;  // of each block, and the end
  std::vector<int> parent_, size_;
  ClusteredCloud cloud_;
};

}  // namespace bslnav
