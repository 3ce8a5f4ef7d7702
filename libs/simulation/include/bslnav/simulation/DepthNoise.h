#pragma once

#include <bslnav/simulation/DepthCameraParameters.h>
#include <mrpt/random/RandomGenerators.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bslnav {

/** One exact depth picture [m], row by row; infinity where nothing is. */
struct DepthPicture {
  const float* depths;
  std::size_t columns, rows;
};

/** What a depth camera makes of exact depths: noise, dropouts, edges, range, millimetres.
 *
 * Every pixel of every frame has its own random bits, hashed from two numbers of the frame and the
 * pixel's number: they do not depend on what other pixels see, and the compiler can work on several
 * pixels at once. Noise is Gaussian to within 4096 quantiles, at most 3.7 standard deviations.
 */
class DepthNoise {
 public:
  static constexpr float kUnit_m = 0.001f;  ///< of the measured depths

  /** @param stream where each frame takes two numbers from */
  DepthNoise(const DepthCameraParameters& parameters, const mrpt::random::CRandomGenerator& stream);

  /** Measures the next frame: writes depths in `kUnit_m`, 0 where nothing is seen. */
  void measure(const DepthPicture& picture, std::uint16_t* measured);

 private:
  void findEdges(const DepthPicture& picture, std::size_t row);

  DepthCameraParameters parameters_;
  mrpt::random::CRandomGenerator stream_;
  std::vector<float> quantiles_;  // of the standard normal distribution
  // Of the row at work: random bits, noise in standard deviations, 1 at an edge.
  std::vector<std::uint32_t> bits_;
  std::vector<float> deviations_;
  std::vector<std::int32_t> edges_;
};

}  // namespace bslnav
