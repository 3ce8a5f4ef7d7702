#pragma once

#include <bslnav/blindspot/DepthClusters.h>

namespace bslnav {

/** The stages of the paper's pipeline as PCL does them (V-B, steps 2a to 2c); each is pure. */

/** Centroids of the points in each voxel with at least `fewestPoints`. */
PointCloud voxelGrid(const PointCloud& points, double leaf_m, int fewestPoints);

/** The points with zMin <= z <= zMax. */
PointCloud passThrough(const PointCloud& points, double zMin_m, double zMax_m);

/** Connected components of points at most `tolerance` apart; −1 for those in smaller ones. */
ClusteredCloud euclideanClusters(const PointCloud& points, double tolerance_m, int fewestPoints);

/** The points with |x|, |y| < reach: the volume of the pipeline. */
PointCloud within(const PointCloud& points, double reach_m);

}  // namespace bslnav
