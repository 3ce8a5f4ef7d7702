#include <bslnav/costmap/PlanarScan.h>

#include <cmath>

namespace bslnav {

void PlanarScan::assign(const mrpt::obs::CObservation2DRangeScan& scan, double maxRange_m) {
  const auto n = scan.getScanSize();
  const bool upsideDown = std::cos(scan.sensorPose.roll()) < 0.0;
  const bool counterclockwise = scan.rightToLeft != upsideDown;
  robotFromSensor_ = {scan.sensorPose.x(), scan.sensorPose.y(), scan.sensorPose.yaw()};
  const double own_m = scan.maxRange;
  maxRange_m_ = maxRange_m > 0.0 && (own_m <= 0.0 || maxRange_m < own_m) ? maxRange_m : own_m;
  hits_ = dropped_ = 0;
  for (auto* values : {&range_m, &cosine, &sine}) values->resize(n);
  beam.resize(n);

  const double step = n > 1 ? scan.aperture / static_cast<double>(n - 1) : 0.0;
  const double first = robotFromSensor_.phi - (n > 1 ? scan.aperture / 2.0 : 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t source = counterclockwise ? i : n - 1 - i;
    const double angle = first + step * static_cast<double>(i);
    cosine[i] = static_cast<float>(std::cos(angle));
    sine[i] = static_cast<float>(std::sin(angle));
    const float range = scan.getScanRange(source);
    const bool valid = scan.getScanRangeValidity(source);
    if (!std::isfinite(range) || (valid && range <= 0.0f)) {
      beam[i] = Beam::Dropped;
      range_m[i] = 0.0f;
      ++dropped_;
    } else if (!valid || range >= maxRange_m_) {
      beam[i] = Beam::NoReturn;
      range_m[i] = static_cast<float>(maxRange_m_);
    } else {
      beam[i] = Beam::Hit;
      range_m[i] = range;
      ++hits_;
    }
  }
}

}  // namespace bslnav
