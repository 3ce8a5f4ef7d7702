#include <bslnav/costmap/CameraCover.h>

#include <bitset>
#include <cmath>

namespace bslnav {
namespace {

constexpr std::size_t kParts = 16;  // of the horizontal view

}  // namespace

bool isViewCovered(const DepthFrame& frame, const std::vector<PlanarScan>& lasers,
                   double within_m) {
  const double fx = frame.geometry()[2], cx = frame.geometry()[4];
  const double left = std::atan2(cx, fx), right = std::atan2(cx - frame.columns(), fx);
  const double c = std::cos(frame.yaw_rad()), s = std::sin(frame.yaw_rad());
  // The part of the view (0 at its right, 1 at its left) in which a point is, from the camera.
  const auto partOf = [&](double x, double y) {
    return (std::atan2(c * y - s * x, c * x + s * y) - right) / (left - right);
  };
  std::bitset<kParts> covered;
  for (const PlanarScan& scan : lasers)
    for (std::size_t k = 0; k < scan.beam.size(); ++k) {
      if (scan.beam[k] == PlanarScan::Beam::Dropped) continue;
      const double x = scan.robotFromSensor().x - static_cast<double>(frame.origin().x) +
                       static_cast<double>(scan.range_m[k] * scan.cosine[k]);
      const double y = scan.robotFromSensor().y - static_cast<double>(frame.origin().y) +
                       static_cast<double>(scan.range_m[k] * scan.sine[k]);
      const double part = partOf(x, y);
      if (part < 0.0 || part >= 1.0) continue;
      if (scan.beam[k] == PlanarScan::Beam::NoReturn || c * x + s * y > within_m) return false;
      covered.set(static_cast<std::size_t>(part * kParts));
    }
  return covered.all();
}

}  // namespace bslnav
