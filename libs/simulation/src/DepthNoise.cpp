#include <bslnav/config/VectorClones.h>
#include <bslnav/simulation/DepthNoise.h>
#include <mrpt/math/distributions.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

// A pixel's 32 random bits: the upper 12 choose a quantile, the lower 20 decide on a dropout.
constexpr int kQuantileBits = 12, kDropoutBits = 20;
constexpr std::uint32_t kDropoutMask = (1U << kDropoutBits) - 1U;

/** The middle quantiles of equally likely intervals, scaled to variance 1. */
std::vector<float> normalQuantiles() {
  constexpr std::size_t n = std::size_t{1} << kQuantileBits;
  std::vector<double> exact(n);
  double squares = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    exact[i] = mrpt::math::normalQuantile((static_cast<double>(i) + 0.5) / static_cast<double>(n));
    squares += exact[i] * exact[i];
  }
  const double deviation = std::sqrt(squares / static_cast<double>(n));
  std::vector<float> quantiles(n);
  for (std::size_t i = 0; i < n; ++i) quantiles[i] = static_cast<float>(exact[i] / deviation);
  return quantiles;
}

/** The finaliser of MurmurHash3 over a pixel's number, with the frame's numbers mixed in. */
inline std::uint32_t hashed(std::uint32_t pixel, std::uint32_t first, std::uint32_t second) {
  std::uint32_t hash = (pixel * 0x9e3779b9U) ^ first;
  hash = (hash ^ (hash >> 16)) * 0x85ebca6bU + second;
  hash = (hash ^ (hash >> 13)) * 0xc2b2ae35U;
  return hash ^ (hash >> 16);
}

/** The bits of `count` pixels from `first` on in the frame with the numbers `a` and `b`. */
BSLNAV_VECTOR_CLONES void drawBits(std::uint32_t first, std::uint32_t a, std::uint32_t b,
                                   std::uint32_t count, std::uint32_t* bits) {
  for (std::uint32_t u = 0; u < count; ++u) bits[u] = hashed(first + u, a, b);
}

/** Whether each of `count` pixels is farther from its neighbour in `there` than the limit. */
BSLNAV_VECTOR_CLONES void addSteps(const float* here, const float* there, float limit,
                                   std::size_t count, std::int32_t* steps) {
  // Infinity beside infinity gives NaN, which is no step.
  for (std::size_t u = 0; u < count; ++u) steps[u] |= std::abs(here[u] - there[u]) > limit ? 1 : 0;
}

/** What is the same for all pixels; depths in units of the measurement. */
struct PixelLimits {
  float noise;
  std::int32_t nearest, farthest;
  std::int32_t dropout, edgeDropout;  // the bits of a dropout are below; the latter adds to it
};

BSLNAV_VECTOR_CLONES void measureRow(const float* depths, const float* deviations,
                                     const std::uint32_t* bits, const std::int32_t* edges,
                                     PixelLimits limits, std::size_t count,
                                     std::uint16_t* measured) {
  constexpr float kPerUnit = 1.0f / DepthNoise::kUnit_m;
  const float beyond = static_cast<float>(limits.farthest + 1);
  for (std::size_t u = 0; u < count; ++u) {
    const float z = depths[u] + limits.noise * depths[u] * depths[u] * deviations[u];
    const float units = z * kPerUnit + 0.5f;  // may be infinite or NaN
    const float atMost = units < beyond ? units : beyond;
    const auto depth = static_cast<std::int32_t>(atMost > 0.0f ? atMost : 0.0f);
    const auto luck = static_cast<std::int32_t>(bits[u] & kDropoutMask);
    const std::int32_t dropout = limits.dropout + limits.edgeDropout * edges[u];
    const int seen = static_cast<int>(depth >= limits.nearest) &
                     static_cast<int>(depth <= limits.farthest) & static_cast<int>(luck >= dropout);
    measured[u] = static_cast<std::uint16_t>(depth * seen);
  }
}

/** A probability as a threshold for the bits of a dropout. */
std::int32_t threshold(double probability) {
  return static_cast<std::int32_t>(std::lround(probability * (1U << kDropoutBits)));
}

PixelLimits limitsOf(const DepthCameraParameters& p) {
  const std::int32_t dropout = threshold(p.dropoutProbability);
  const double atEdge = 1.0 - (1.0 - p.dropoutProbability) * (1.0 - p.edgeDropoutProbability);
  const auto units = [](double depth_m) {
    return static_cast<std::int32_t>(
        std::lround(depth_m / static_cast<double>(DepthNoise::kUnit_m)));
  };
  return {static_cast<float>(p.noiseCoefficient), units(p.minRange_m), units(p.maxRange_m), dropout,
          threshold(atEdge) - dropout};
}

}  // namespace

DepthNoise::DepthNoise(const DepthCameraParameters& parameters,
                       const mrpt::random::CRandomGenerator& stream)
    : parameters_(parameters), stream_(stream), quantiles_(normalQuantiles()) {
  const auto columns = static_cast<std::size_t>(parameters.columns);
  bits_.resize(columns);
  deviations_.resize(columns);
  edges_.resize(columns);
}

void DepthNoise::measure(const DepthPicture& picture, std::uint16_t* measured) {
  const std::size_t n = picture.columns;
  const PixelLimits limits = limitsOf(parameters_);
  const std::uint32_t a = stream_.drawUniform32bit(), b = stream_.drawUniform32bit();
  for (std::size_t row = 0; row < picture.rows; ++row) {
    const float* depths = picture.depths + row * n;
    findEdges(picture, row);
    drawBits(static_cast<std::uint32_t>(row * n), a, b, static_cast<std::uint32_t>(n),
             bits_.data());
    for (std::size_t u = 0; u < n; ++u) deviations_[u] = quantiles_[bits_[u] >> kDropoutBits];
    measureRow(depths, deviations_.data(), bits_.data(), edges_.data(), limits, n,
               measured + row * n);
  }
}

void DepthNoise::findEdges(const DepthPicture& picture, std::size_t row) {
  const std::size_t n = picture.columns;
  const float* here = picture.depths + row * n;
  const auto limit = static_cast<float>(parameters_.edgeStep_m);
  std::fill(edges_.begin(), edges_.end(), 0);
  if (row > 0) addSteps(here, here - n, limit, n, edges_.data());
  if (row + 1 < picture.rows) addSteps(here, here + n, limit, n, edges_.data());
  addSteps(here, here + 1, limit, n - 1, edges_.data());
  addSteps(here + 1, here, limit, n - 1, edges_.data() + 1);
}

}  // namespace bslnav
