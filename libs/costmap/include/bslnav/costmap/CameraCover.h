#pragma once

#include <bslnav/costmap/DepthFrame.h>
#include <bslnav/costmap/PlanarScan.h>

#include <vector>

namespace bslnav {

/** Whether lasers meet something right before a depth camera, all across its view: nearer than its
 * least depth, it sees nothing there, and is not broken.
 *
 * The lasers need not be as high as the camera: it may look over what they meet.
 * @param lasers in the same robot frame
 * @param within_m so near, from the camera along its optical axis */
bool isViewCovered(const DepthFrame& frame, const std::vector<PlanarScan>& lasers, double within_m);

}  // namespace bslnav
