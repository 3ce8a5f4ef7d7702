#include <bslnav/config/Config.h>
#include <bslnav/simulation/LaserSensor.h>
#include <bslnav/simulation/RandomStream.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

using mrpt::obs::CObservation2DRangeScan;

std::vector<RayPacket> beamDirections(const CObservation2DRangeScan& scan) {
  const std::size_t n = scan.getScanSize();
  std::vector<RayPacket> packets((n + RayPacket::kSize - 1) / RayPacket::kSize);
  for (std::size_t i = 0; i < packets.size() * RayPacket::kSize; ++i) {
    const double angle =
        (static_cast<double>(std::min(i, n - 1)) / static_cast<double>(n - 1) - 0.5) *
        static_cast<double>(scan.aperture);
    auto& packet = packets[i / RayPacket::kSize];
    packet.x[i % RayPacket::kSize] = static_cast<float>(std::cos(angle));
    packet.y[i % RayPacket::kSize] = static_cast<float>(std::sin(angle));
    packet.z[i % RayPacket::kSize] = 0.0f;
  }
  return packets;
}

RayPacket rotated(const RayPacket& rays, float cosine, float sine) {
  RayPacket result = rays;
  for (std::size_t i = 0; i < RayPacket::kSize; ++i) {
    result.x[i] = cosine * rays.x[i] - sine * rays.y[i];
    result.y[i] = sine * rays.x[i] + cosine * rays.y[i];
  }
  return result;
}

}  // namespace

void LaserParameters::describe(ConfigSection& section) {
  section.number("x_m", x_m, {}, "m", "position on the robot, forward");
  section.number("y_m", y_m, {}, "m", "position on the robot, to the left");
  section.number("z_m", z_m, kPositive, "m", "height above the floor");
  section.angle("yaw_deg", yaw_rad, {-360.0, 360.0}, "direction of the middle beam on the robot");
  section.angle("fov_deg", fov_rad, {1.0, 360.0}, "field of view, first to last beam");
  section.integer("beams", beams, {2, 100000}, "", "beams of a scan");
  section.number("min_range_m", minRange_m, kNonNegative, "m", "nearer surfaces are not seen");
  section.number("max_range_m", maxRange_m, kPositive, "m", "farther surfaces are not seen");
  section.number("rate_hz", rate_hz, {0.1, 100.0}, "Hz", "scans a second");
  section.number("latency_s", latency_s, {0.0, 10.0}, "s", "from the measurement to its delivery");
  section.number("noise_std_m", noiseStd_m, kNonNegative, "m", "standard deviation of a range");
  section.number("dropout_probability", dropoutProbability, {0.0, 1.0}, "",
                 "share of beams that see nothing");
}

LaserSensor::LaserSensor(const std::string& name, const LaserParameters& parameters,
                         std::uint64_t seed)
    : parameters_(parameters),
      rangeNoise_(randomStream(seed, "laser/" + name + "/range")),
      dropouts_(randomStream(seed, "laser/" + name + "/dropout")) {
  if (!(parameters.maxRange_m > parameters.minRange_m))
    Config::refuse("laser:" + name, "max_range_m", "a range above min_range_m");
  if (parameters.beams < 2) Config::refuse("laser:" + name, "beams", "at least 2");
  if (!(parameters.rate_hz > 0.0)) Config::refuse("laser:" + name, "rate_hz", "a number above 0");
  blank_.sensorLabel = name;
  blank_.sensorPose = {
      parameters.x_m, parameters.y_m, parameters.z_m, parameters.yaw_rad, 0.0, 0.0};
  blank_.aperture = static_cast<float>(parameters.fov_rad);
  blank_.rightToLeft = true;
  blank_.maxRange = static_cast<float>(parameters.maxRange_m);
  blank_.stdError = static_cast<float>(parameters.noiseStd_m);
  blank_.resizeScanAndAssign(static_cast<std::size_t>(parameters.beams), blank_.maxRange, false);
  beamDirections_ = beamDirections(blank_);
  distances_m_.resize(beamDirections_.size() * RayPacket::kSize);
}

CObservation2DRangeScan::Ptr LaserSensor::unusedScan() {
  for (const auto& scan : pool_)
    if (scan.use_count() == 1) return scan;
  pool_.push_back(CObservation2DRangeScan::Create());
  return pool_.back();
}

void LaserSensor::measure(float distance_m, CObservation2DRangeScan& scan, std::size_t beam) {
  // Every beam draws from both streams, so that one beam's luck does not shift the next one's.
  const double noise_m =
      parameters_.noiseStd_m > 0.0 ? rangeNoise_.drawGaussian1D(0.0, parameters_.noiseStd_m) : 0.0;
  const bool dropped = parameters_.dropoutProbability > 0.0 &&
                       dropouts_.drawUniform(0.0, 1.0) < parameters_.dropoutProbability;
  const double range_m = static_cast<double>(distance_m) + noise_m;
  if (dropped || !(range_m >= parameters_.minRange_m && range_m < parameters_.maxRange_m)) return;
  scan.setScanRange(beam, static_cast<float>(range_m));
  scan.setScanRangeValidity(beam, true);
}

CObservation2DRangeScan::Ptr LaserSensor::scan(const std::vector<float>& distances_m,
                                               mrpt::Clock::time_point stamp) {
  auto scan = unusedScan();
  *scan = blank_;
  scan->timestamp = stamp;
  for (std::size_t i = 0; i < scan->getScanSize(); ++i) measure(distances_m[i], *scan, i);
  return scan;
}

CObservation2DRangeScan::Ptr LaserSensor::scan(const RayScene& scene,
                                               const mrpt::math::TPose2D& mapFromRobot,
                                               mrpt::Clock::time_point stamp) {
  const auto mapFromSensor =
      mapFromRobot + mrpt::math::TPose2D(parameters_.x_m, parameters_.y_m, parameters_.yaw_rad);
  const mrpt::math::TPoint3Df origin(static_cast<float>(mapFromSensor.x),
                                     static_cast<float>(mapFromSensor.y),
                                     static_cast<float>(parameters_.z_m));
  const auto cosine = static_cast<float>(std::cos(mapFromSensor.phi));
  const auto sine = static_cast<float>(std::sin(mapFromSensor.phi));
  for (std::size_t p = 0; p < beamDirections_.size(); ++p) {
    const auto distances =
        scene.rayHits(origin, rotated(beamDirections_[p], cosine, sine), blank_.maxRange);
    std::copy(distances.begin(), distances.end(),
              distances_m_.begin() + static_cast<std::ptrdiff_t>(p * RayPacket::kSize));
  }
  return scan(distances_m_, stamp);
}

}  // namespace bslnav
