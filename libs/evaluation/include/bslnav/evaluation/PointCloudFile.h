#pragma once

#include <bslnav/blindspot/DepthClusters.h>

#include <string>
#include <vector>

namespace bslnav {

/** What clouds are saved as. */
enum class CloudFormat : std::uint8_t { None, Pcd, Ply };

/** Writes points, and with `labels` the cluster of each (−1 for none), as an ASCII .pcd or .ply.
 * @returns the file's path: `stem` and the format's extension
 * @throws Error (Run) when it cannot be written */
std::string saveCloud(const std::string& stem, CloudFormat format, const PointCloud& points,
                      const std::vector<int>& labels = {});

}  // namespace bslnav
