#include <bslnav/simulation/DepthNoise.h>
#include <mrpt/math/distributions.h>

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

/** A probability as a threshold for the bits of a dropout. */
std::int32_t threshold(double probability) {
  return static_cast<std::int32_t>(std::lround(probability * (1U << kDropoutBits)));
}

}  // namespace

DepthNoise::DepthNoise(const DepthCameraParameters& parameters,
                       const mrpt::random::CRandomGenerator& stream)
    : parameters_(parameters), stream_(stream), quantiles_(normalQuantiles()) {
  const auto columns = static_cast<std::size_t>(parameters.columns);
  bits_.resize(columns);
  deviations_.resize(columns);
  edges_.resize(columns);
  steps_.resize(columns + 1);  // steps_[u] lies left of column u; none at the picture's borders
}

void DepthNoise::measure(const DepthPicture& picture, std::uint16_t* measured) {
  for (auto& number : frame_) number = stream_.drawUniform32bit();
  for (std::size_t row = 0; row < picture.rows; ++row) {
    const std::size_t first = row * picture.columns;
    findEdges(picture, row);
    drawBits(first);
    measureRow(picture.depths + first, measured + first);
  }
}

void DepthNoise::findEdges(const DepthPicture& picture, std::size_t row) {
  const std::size_t n = picture.columns;
  const float* here = picture.depths + row * n;
  const float* above = row > 0 ? here - n : here;
  const float* below = row + 1 < picture.rows ? here + n : here;
  const auto limit = static_cast<float>(parameters_.edgeStep_m);
  // Infinity beside infinity gives NaN, which is no edge.
  const auto isStep = [limit](float a, float b) -> std::int32_t {
    return std::abs(a - b) > limit ? 1 : 0;
  };
  for (std::size_t u = 1; u < n; ++u) steps_[u] = isStep(here[u - 1], here[u]);
  for (std::size_t u = 0; u < n; ++u)
    edges_[u] = isStep(above[u], here[u]) | isStep(below[u], here[u]) | steps_[u] | steps_[u + 1];
}

void DepthNoise::drawBits(std::size_t firstPixel) {
  const auto first = static_cast<std::uint32_t>(firstPixel);
  const std::uint32_t a = frame_[0], b = frame_[1];
  const auto n = static_cast<std::uint32_t>(bits_.size());
  for (std::uint32_t u = 0; u < n; ++u) bits_[u] = hashed(first + u, a, b);
  for (std::uint32_t u = 0; u < n; ++u) deviations_[u] = quantiles_[bits_[u] >> kDropoutBits];
}

void DepthNoise::measureRow(const float* depths, std::uint16_t* measured) {
  const double stays = 1.0 - parameters_.dropoutProbability;
  const std::int32_t plain = threshold(parameters_.dropoutProbability);
  const std::int32_t atEdge =
      threshold(1.0 - stays * (1.0 - parameters_.edgeDropoutProbability)) - plain;
  const auto coefficient = static_cast<float>(parameters_.noiseCoefficient);
  const auto minimum = static_cast<float>(parameters_.minRange_m);
  const auto maximum = static_cast<float>(parameters_.maxRange_m);
  for (std::size_t u = 0; u < bits_.size(); ++u) {
    const float z = depths[u] + coefficient * depths[u] * depths[u] * deviations_[u];
    const auto luck = static_cast<std::int32_t>(bits_[u] & kDropoutMask);
    const bool seen = (z >= minimum) & (z <= maximum) & (luck >= plain + atEdge * edges_[u]);
    measured[u] = static_cast<std::uint16_t>(static_cast<int>((seen ? z : 0.0f) / kUnit_m + 0.5f));
  }
}

}  // namespace bslnav
