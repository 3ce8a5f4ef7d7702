#include <bslnav/config/ConfigSection.h>
#include <bslnav/config/Error.h>
#include <bslnav/navigation/LocalizationParticleFilter.h>
#include <mrpt/bayes/CParticleFilter.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/slam/CMonteCarloLocalization2D.h>

#include <cmath>
#include <sstream>

#include "OwnGenerator.h"

namespace bslnav {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPose2D;
using mrpt::obs::CActionRobotMovement2D;
using mrpt::obs::CObservation2DRangeScan;

constexpr std::size_t kFewestBeams = 2;  // MRPT takes no scan with fewer

/** A copy of a map with the settings of the likelihood in it. */
COccupancyGridMap2D::Ptr likelihoodMap(const COccupancyGridMap2D& map,
                                       const ParticleFilterParameters& p) {
  auto copy = std::make_shared<COccupancyGridMap2D>(map);
  auto& options = copy->likelihoodOptions;
  const auto deviation_m = static_cast<float>(p.hitDeviation_m);
  options.likelihoodMethod = p.likelihood == ParticleFilterParameters::Likelihood::Field
                                 ? COccupancyGridMap2D::lmLikelihoodField_Thrun
                                 : COccupancyGridMap2D::lmRayTracing;
  options.LF_decimation = static_cast<std::uint32_t>(p.beamDecimation);
  options.LF_stdHit = deviation_m;
  options.LF_maxCorrsDistance = 2.0f * deviation_m;
  options.LF_maxRange = static_cast<float>(p.maxRange_m);
  options.enableLikelihoodCache = true;
  options.rayTracing_decimation = p.beamDecimation;
  options.rayTracing_stdHit = deviation_m;
  return copy;
}

/** A scan with the beams that say nothing marked invalid: the filter would take NaN for a cell of
 * the map. */
CObservation2DRangeScan::Ptr usableScan(const CObservation2DRangeScan& scan, double maxRange_m) {
  auto usable = std::make_shared<CObservation2DRangeScan>();  // a copy would share the cached
                                                              // points of all beams
  usable->aperture = scan.aperture;
  usable->rightToLeft = scan.rightToLeft;
  usable->maxRange = scan.maxRange;
  usable->sensorPose = scan.sensorPose;
  usable->timestamp = scan.timestamp;
  usable->resizeScanAndAssign(scan.getScanSize(), 0.0f, false);
  for (std::size_t i = 0; i < scan.getScanSize(); ++i) {
    const float range = scan.getScanRange(i);
    const bool inRange = range > 0.0f && range < scan.maxRange && range < maxRange_m;  // NaN is not
    if (!inRange || !scan.getScanRangeValidity(i)) continue;
    usable->setScanRange(i, range);
    usable->setScanRangeValidity(i, true);
  }
  return usable;
}

void checkInside(const COccupancyGridMap2D& map, const TPose2D& pose) {
  if (pose.x >= map.getXMin() && pose.x <= map.getXMax() && pose.y >= map.getYMin() &&
      pose.y <= map.getYMax() && std::isfinite(pose.phi))
    return;
  std::ostringstream expected;
  expected << "is outside the map; expected x from " << map.getXMin() << " to " << map.getXMax()
           << " m, y from " << map.getYMin() << " to " << map.getYMax() << " m";
  throw Error("initial pose " + pose.asString(), expected.str());
}

CActionRobotMovement2D::TMotionModelOptions motionModel(const ParticleFilterParameters& p) {
  CActionRobotMovement2D::TMotionModelOptions options;
  options.modelSelection = CActionRobotMovement2D::mmGaussian;
  options.gaussianModel = {p.translationNoise, p.translationNoise_mprad,  p.rotationNoise_radpm,
                           p.rotationNoise,    p.leastTranslationNoise_m, p.leastRotationNoise_rad};
  return options;
}

}  // namespace

void ParticleFilterParameters::describe(ConfigSection& section) {
  section.integer("particles", particles, {10, 100000}, "", "number of particles");
  section.number("initial_spread_m", initialSpread_m, kNonNegative, "m",
                 "particles start up to this far from the initial position, in x and in y");
  section.angle("initial_spread_deg", initialSpread_rad, {0.0, 180.0},
                "particles start up to this far from the initial heading");
  section.number("translation_noise_m_per_m", translationNoise, kNonNegative, "m/m",
                 "standard deviation of the position per distance driven");
  section.number("translation_noise_m_per_rad", translationNoise_mprad, kNonNegative, "m/rad",
                 "standard deviation of the position per angle turned");
  section.number("rotation_noise_rad_per_rad", rotationNoise, kNonNegative, "rad/rad",
                 "standard deviation of the heading per angle turned");
  section.number("rotation_noise_rad_per_m", rotationNoise_radpm, kNonNegative, "rad/m",
                 "standard deviation of the heading per distance driven");
  section.number("least_translation_noise_m", leastTranslationNoise_m, kPositive, "m",
                 "standard deviation of the position added in every frame");
  section.angle("least_rotation_noise_deg", leastRotationNoise_rad, {1e-6, 180.0},
                "standard deviation of the heading added in every frame");
  section.choice("likelihood", likelihood,
                 {{"field", Likelihood::Field}, {"ray_tracing", Likelihood::RayTracing}},
                 "how a scan weighs a particle: distance of its end points to occupied cells, or "
                 "expected ranges");
  section.integer("beam_decimation", beamDecimation, {1, 1000}, "", "every n-th beam is used");
  section.number("max_range_m", maxRange_m, kPositive, "m", "longer ranges are not used");
  section.number("hit_deviation_m", hitDeviation_m, {0.01, 1.0}, "m",
                 "standard deviation of a range, errors of the map included");
}

struct ParticleFilterLocalization::Filter {
  explicit Filter(std::uint32_t seed) : generator(seed) {}

  mrpt::random::CRandomGenerator generator;
  ParticleFilterParameters parameters;
  CActionRobotMovement2D::TMotionModelOptions motion;
  mrpt::bayes::CParticleFilter algorithm;
  mrpt::slam::CMonteCarloLocalization2D particles;
  TPose2D odometry;
  bool hasOdometry = false;

  mrpt::obs::CActionCollection movementTo(const TPose2D& newOdometry) const {
    CActionRobotMovement2D movement;
    movement.computeFromOdometry(mrpt::poses::CPose2D(newOdometry - odometry), motion);
    mrpt::obs::CActionCollection actions;
    actions.insert(movement);
    return actions;
  }
};

ParticleFilterLocalization::ParticleFilterLocalization(
    const ParticleFilterParameters& parameters,
    const std::shared_ptr<const COccupancyGridMap2D>& map, const TPose2D& initialPose,
    std::uint32_t seed)
    : filter_(std::make_unique<Filter>(seed)) {
  checkInside(*map, initialPose);
  const OwnGenerator draw(filter_->generator);
  filter_->parameters = parameters;
  filter_->motion = motionModel(parameters);
  filter_->algorithm.m_options.resamplingMethod = mrpt::bayes::CParticleFilter::prSystematic;
  auto& particles = filter_->particles;
  particles.options.metricMap = likelihoodMap(*map, parameters);
  const TPose2D& pose = initialPose;
  const double d = parameters.initialSpread_m, turn = parameters.initialSpread_rad;
  particles.resetUniform(pose.x - d, pose.x + d, pose.y - d, pose.y + d, pose.phi - turn,
                         pose.phi + turn, parameters.particles);
}

ParticleFilterLocalization::~ParticleFilterLocalization() = default;

TPose2D ParticleFilterLocalization::update(const SensorFrame& frame) {
  const OwnGenerator draw(filter_->generator);
  mrpt::obs::CSensoryFrame scans;
  for (const auto& scan : frame.scans)
    if (scan->getScanSize() >= kFewestBeams)
      scans.insert(usableScan(*scan, filter_->parameters.maxRange_m));
  if (filter_->hasOdometry && !frame.afterGap) {
    const auto movement = filter_->movementTo(frame.odometry);
    filter_->algorithm.executeOn(filter_->particles, &movement, &scans);
  } else {
    filter_->algorithm.executeOn(filter_->particles, nullptr, &scans);
  }
  filter_->odometry = frame.odometry;
  filter_->hasOdometry = true;
  const auto [covariance, mean] = filter_->particles.getCovarianceAndMean();
  spread_m_ = std::sqrt(covariance(0, 0) + covariance(1, 1));
  return mean.asTPose();
}

}  // namespace bslnav
