#include <bslnav/navigation/DepthCameras.h>

#include <algorithm>

namespace bslnav {

void DepthCameras::beginCycle() {
  for (Camera& camera : cameras_) camera.isNew = false;
}

DepthCameras::Camera& DepthCameras::cameraOf(const std::string& label) {
  for (Camera& camera : cameras_)
    if (camera.label == label) return camera;
  cameras_.push_back({label, nullptr, 0.0, false, {}, DepthScan(parameters_)});
  return cameras_.back();
}

const DepthFrame& DepthCameras::add(const mrpt::obs::CObservation3DRangeScan::ConstPtr& image,
                                    double stamp_s, const MotionHistory& motion) {
  Camera& camera = cameraOf(image->sensorLabel);
  camera.frame.assign(*image, motion.nowFromThen(stamp_s));
  if (camera.frame.status() != DepthFrame::Status::Ok) {
    std::swap(refused_, camera.frame);
    return refused_;
  }
  camera.image = image;
  camera.stamp_s = stamp_s;
  camera.isNew = true;
  return camera.frame;
}

const std::vector<const DepthFrame*>& DepthCameras::framesSince(double time_s,
                                                                const MotionHistory& motion) {
  frames_.clear();
  for (Camera& camera : cameras_) {
    if (!camera.image || camera.stamp_s < time_s) continue;
    if (!camera.isNew) camera.frame.assign(*camera.image, motion.nowFromThen(camera.stamp_s));
    frames_.push_back(&camera.frame);
  }
  return frames_;
}

const std::vector<PlanarScan>& DepthCameras::newScans() {
  std::size_t count = 0;
  for (Camera& camera : cameras_) {
    if (!camera.isNew) continue;
    if (scans_.size() <= count) scans_.emplace_back();
    scans_[count++] = camera.scan.make(camera.frame);
  }
  scans_.resize(count);
  return scans_;
}

bool DepthCameras::hasNew() const {
  return std::any_of(cameras_.begin(), cameras_.end(), [](const Camera& c) { return c.isNew; });
}

}  // namespace bslnav
