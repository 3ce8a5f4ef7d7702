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
  incoming_.assign(*image, motion.nowFromThen(stamp_s));
  if (incoming_.status() != DepthFrame::Status::Ok) return incoming_;
  std::swap(incoming_, camera.frame);
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
  for (; !scans_.empty(); scans_.pop_back()) spareScans_.push_back(std::move(scans_.back()));
  for (Camera& camera : cameras_) {
    if (!camera.isNew) continue;
    if (spareScans_.empty()) spareScans_.emplace_back();
    scans_.push_back(std::move(spareScans_.back()));
    spareScans_.pop_back();
    scans_.back() = camera.scan.make(camera.frame);
  }
  return scans_;
}

bool DepthCameras::hasNew() const {
  return std::any_of(cameras_.begin(), cameras_.end(), [](const Camera& c) { return c.isNew; });
}

}  // namespace bslnav
