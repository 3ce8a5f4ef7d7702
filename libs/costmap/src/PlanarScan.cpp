#include <bslnav/costmap/PlanarScan.h>

#include <cmath>

namespace bslnav {

void PlanarScan::reset(const mrpt::math::TPose2D& robotFromSensor, double maxRange_m,
                       std::size_t beams) {
  robotFromSensor_ = robotFromSensor;
  maxRange_m_ = maxRange_m;
  hits_ = 0;
  dropped_ = static_cast<int>(beams);
  for (auto* values : {&cosine, &sine}) values->resize(beams);
  range_m.assign(beams, 0.0f);
  beam.assign(beams, Beam::Dropped);
  start_m.clear();
  steepest.clear();
  top_m.clear();
}

void PlanarScan::setBeam(std::size_t i, Beam what, float measured_m) {
  dropped_ += (what == Beam::Dropped) - (beam[i] == Beam::Dropped);
  hits_ += (what == Beam::Hit) - (beam[i] == Beam::Hit);
  beam[i] = what;
  range_m[i] = measured_m;
}

void PlanarScan::assign(const mrpt::obs::CObservation2DRangeScan& scan, double maxRange_m,
                        const mrpt::math::TPose2D& robotFromThen) {
  const auto n = scan.getScanSize();
  const bool upsideDown = std::cos(scan.sensorPose.roll()) < 0.0;
  const bool counterclockwise = scan.rightToLeft != upsideDown;
  const double own_m = scan.maxRange;
  reset(robotFromThen +
            mrpt::math::TPose2D(scan.sensorPose.x(), scan.sensorPose.y(), scan.sensorPose.yaw()),
        maxRange_m > 0.0 && (own_m <= 0.0 || maxRange_m < own_m) ? maxRange_m : own_m, n);

  const double step = n > 1 ? scan.aperture / static_cast<double>(n - 1) : 0.0;
  const double first = robotFromSensor_.phi - (n > 1 ? scan.aperture / 2.0 : 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t source = counterclockwise ? i : n - 1 - i;
    const double angle = first + step * static_cast<double>(i);
    cosine[i] = static_cast<float>(std::cos(angle));
    sine[i] = static_cast<float>(std::sin(angle));
    const float range = scan.getScanRange(source);
    const bool valid = scan.getScanRangeValidity(source);
    if (!std::isfinite(range) || (valid && range <= 0.0f)) continue;
    if (!valid || range >= maxRange_m_)
      setBeam(i, Beam::NoReturn, static_cast<float>(maxRange_m_));
    else
      setBeam(i, Beam::Hit, range);
  }
}

}  // namespace bslnav
