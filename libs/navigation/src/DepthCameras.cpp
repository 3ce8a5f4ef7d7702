#include <bslnav/navigation/DepthCameras.h>

#include <algorithm>
#include <utility>

namespace bslnav {

void DepthCameras::beginCycle() {
  for (Camera& camera : cameras_) camera.isNew = false;
}

DepthCameras::Camera& DepthCameras::cameraOf(const std::string& label) {
  for (Camera& camera : cameras_)
    if (camera.label == label) return camera;
  cameras_.push_back(
      {label, nullptr, 0.0, false, {}, DepthScan(obstacles_), PersonVisibility(people_)});
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

void DepthCameras::Scans::clear() {
  for (; !used.empty(); used.pop_back()) spare.push_back(std::move(used.back()));
}

void DepthCameras::Scans::add(const PlanarScan& scan) {
  if (spare.empty()) spare.emplace_back();
  used.push_back(std::move(spare.back()));
  spare.pop_back();
  used.back() = scan;
}

const std::vector<PlanarScan>& DepthCameras::newScans() {
  scans_.clear();
  for (Camera& camera : cameras_)
    if (camera.isNew) scans_.add(camera.scan.make(camera.frame));
  return scans_.used;
}

const std::vector<PlanarScan>& DepthCameras::newPersonViews() {
  personViews_.clear();
  for (Camera& camera : cameras_)
    if (camera.isNew) personViews_.add(camera.people.make(camera.frame));
  return personViews_.used;
}

bool DepthCameras::hasSince(double time_s) const {
  return std::any_of(cameras_.begin(), cameras_.end(), [time_s](const Camera& camera) {
    return camera.image && camera.stamp_s >= time_s;
  });
}

std::optional<double> DepthCameras::oldestNew_s() const {
  std::optional<double> oldest_s;
  for (const Camera& camera : cameras_)
    if (camera.isNew && camera.stamp_s < oldest_s.value_or(camera.stamp_s + 1.0))
      oldest_s = camera.stamp_s;
  return oldest_s;
}

}  // namespace bslnav
