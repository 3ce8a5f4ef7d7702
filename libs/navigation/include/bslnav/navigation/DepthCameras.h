#pragma once

#include <bslnav/blindspot/PersonVisibility.h>
#include <bslnav/costmap/DepthScan.h>
#include <bslnav/navigation/MotionHistory.h>

#include <deque>
#include <optional>
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
    PersonVisibility people;
  };

  DepthCameras(const DepthScanParameters& obstacles, const PersonVisibilityParameters& people)
      : obstacles_(obstacles), people_(people) {}

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
  /** The scans of obstacles made of this cycle's new images. */
  const std::vector<PlanarScan>& newScans();
  /** How far people would be seen in this cycle's new images. */
  const std::vector<PlanarScan>& newPersonViews();
  bool hasNew() const { return oldestNew_s().has_value(); }
  /** Whether a usable image was taken since a time. */
  bool hasSince(double time_s) const;
  /** When the oldest of this cycle's new images was taken. */
  std::optional<double> oldestNew_s() const;

 private:
  /** Scans whose buffers are kept when there are fewer. */
  struct Scans {
    std::vector<PlanarScan> used, spare;

    void clear();
    void add(const PlanarScan& scan);
  };

  Camera& cameraOf(const std::string& label);

  DepthScanParameters obstacles_;
  PersonVisibilityParameters people_;
  std::deque<Camera> cameras_;
  DepthFrame incoming_;
  std::vector<const DepthFrame*> frames_;
  Scans scans_, personViews_;
};

}  // namespace bslnav
