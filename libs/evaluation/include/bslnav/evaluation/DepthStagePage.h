#pragma once

#include <bslnav/blindspot/DepthClusterDetector.h>
#include <bslnav/evaluation/PointCloudFile.h>
#include <bslnav/navigation/NavigationCycle.h>
#include <bslnav/pictures/Picture.h>

#include <string>
#include <vector>

namespace bslnav {

/** From a cycle's depth images to its danger zones, on one page; and the clouds on the way. */
class DepthStagePage {
 public:
  /** Draws the page now: cloud, voxels, without ground, clusters, boundaries, cost map.
   * @param cycle has depth images: cycle.surroundings().depthFrames() is not empty */
  DepthStagePage(const CycleRecord& record, const NavigationCycle& cycle,
                 const NavigationParameters& parameters);

  /** Writes NAME.png and, unless the format is None, NAME-points, NAME-voxels and NAME-clusters
   * into a directory.
   * @returns the picture's path  @throws Error (Run) when a file cannot be written */
  std::string save(const std::string& directory, const std::string& name, CloudFormat format) const;

 private:
  DepthStages stages_;
  Picture page_;
};

}  // namespace bslnav
