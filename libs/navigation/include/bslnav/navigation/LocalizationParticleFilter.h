#pragma once

#include <bslnav/navigation/Localization.h>

#include <cstdint>
#include <memory>

namespace mrpt::maps {
class COccupancyGridMap2D;
}

namespace bslnav {

class ConfigSection;

/** How a particle filter starts, moves and weighs its particles. */
struct ParticleFilterParameters {
  enum class Likelihood {
    Field,      ///< distance of the scan's end points to occupied cells (Thrun's likelihood field)
    RayTracing  ///< measured against expected range
  };

  int particles = 500;
  double initialSpread_m = 0.3;
  double initialSpread_rad = 0.1;  ///< 5.7°
  double translationNoise = 0.05;  ///< m of standard deviation per m driven
  double translationNoise_mprad = 0.05;
  double rotationNoise = 0.1;  ///< rad per rad turned
  double rotationNoise_radpm = 0.03;
  double leastTranslationNoise_m = 0.01;  ///< of every frame
  double leastRotationNoise_rad = 0.005;
  Likelihood likelihood = Likelihood::Field;
  int beamDecimation = 5;
  double maxRange_m = 30.0;
  double hitDeviation_m = 0.2;

  void describe(ConfigSection& section);
};

/** Localises a robot in a known map with MRPT's particle filter (CMonteCarloLocalization2D).
 *
 * It starts at a known pose: a global search would not be repeatable. Every filter draws from a
 * random generator of its own: the same frames give the same poses whatever else runs in the
 * process, also other filters in other threads; one filter is used by one thread at a time. Over a
 * gap the particles stay where they are. */
class ParticleFilterLocalization : public Localization {
 public:
  /** @param map copied, since MRPT keeps likelihoods and their settings in it
   *  @param initialPose in the map, at the first frame
   *  @throws Error when the initial pose is outside the map */
  ParticleFilterLocalization(const ParticleFilterParameters& parameters,
                             const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map,
                             const mrpt::math::TPose2D& initialPose, std::uint32_t seed);
  ~ParticleFilterLocalization() override;

  mrpt::math::TPose2D update(const SensorFrame& frame) override;
  double spread_m() const override { return spread_m_; }

 private:
  struct Filter;
  std::unique_ptr<Filter> filter_;
  double spread_m_ = 0.0;
};

}  // namespace bslnav
