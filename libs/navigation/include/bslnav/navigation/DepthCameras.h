#pragma once

#include <bslnav/costmap/DepthScan.h>
#include <bslnav/navigation/MotionHistory.h>

#include <deque>
#include <string>
#include <vector>

namespace bslnav {

/** The newest image of each depth camera, where the robot is now. */
class DepthCameras {
 public:
  struct Camera {
    std::string label;
    mrpt::obs::CObservation3DRangeScan::ConstPtr image;  ///< newest usable one; null: none yet
    double stamp_s = 0.0;
    bool isNew = false;  ///< arrived in this cycle
    DepthFrame frame;
    DepthScan scan;
  };

  explicit DepthCameras(const DepthScanParameters& parameters) : parameters_(parameters) {}

  /** Before the images of a cycle. */
  void beginCycle();
  /** Takes in a new image.
   * @return its status; anything but Ok leaves the camera with the image that it had */
  const DepthFrame& add(const mrpt::obs::CObservation3DRangeScan::ConstPtr& image, double stamp_s,
                        const MotionHistory& motion);

  /** The images taken since a time, brought to where the robot is now; valid until the next cycle.
   */
  const std::vector<const DepthFrame*>& framesSince(double time_s, const MotionHistory& motion);
  /** What framesSince() returned last. */
  const std::vector<const DepthFrame*>& frames() const { return frames_; }
  /** The scans made of this cycle's new images. */
  const std::vector<PlanarScan>& newScans();
  bool hasNew() const;

 private:
  Camera& cameraOf(const std::string& label);

  DepthScanParameters parameters_;
  std::deque<Camera> cameras_;
  DepthFrame incoming_;
  std::vector<const DepthFrame*> frames_;
  std::vector<PlanarScan> scans_, spareScans_;  // spare: buffers of cycles with more new images
};

}  // namespace bslnav
