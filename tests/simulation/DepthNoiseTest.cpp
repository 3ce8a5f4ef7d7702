#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "DepthCameraRig.h"

namespace bslnav {
namespace {

constexpr std::size_t kColumns = 160, kRows = 120, kPixels = kColumns * kRows;

DepthCameraParameters quiet() {
  auto parameters = test::exactCamera();
  parameters.columns = kColumns;
  parameters.rows = kRows;
  return parameters;
}

DepthNoise noiseOf(const DepthCameraParameters& parameters, std::uint32_t seed = 7) {
  return {parameters, mrpt::random::CRandomGenerator(seed)};
}

std::vector<int> measured(DepthNoise& noise, const std::vector<float>& depths) {
  std::vector<std::uint16_t> result(kPixels);
  noise.measure({depths.data(), kColumns, kRows}, result.data());
  return {result.begin(), result.end()};
}

std::vector<float> plane(float depth_m) { return std::vector<float>(kPixels, depth_m); }

/** A block of columns 50 to 69 and rows 40 to 79, `step_m` before a plane at 4 m. */
std::vector<float> block(float step_m) {
  auto depths = plane(4.0f);
  for (std::size_t v = 40; v < 80; ++v)
    for (std::size_t u = 50; u < 70; ++u) depths[v * kColumns + u] -= step_m;
  return depths;
}

/** Whether a pixel of that block, or of its surroundings, has a neighbour on the other side. */
bool atBorder(std::size_t pixel) {
  const std::size_t u = pixel % kColumns, v = pixel / kColumns;
  const bool columns = u >= 50 && u < 70, rows = v >= 40 && v < 80;
  return (rows && (u == 49 || u == 50 || u == 69 || u == 70)) ||
         (columns && (v == 39 || v == 40 || v == 79 || v == 80));
}

TEST(DepthNoise, ExactDepthsAreRoundedToMillimetres) {
  auto noise = noiseOf(quiet());
  EXPECT_EQ(measured(noise, plane(2.0004f)), std::vector<int>(kPixels, 2000));
  EXPECT_EQ(measured(noise, plane(2.0006f)), std::vector<int>(kPixels, 2001));
  EXPECT_EQ(measured(noise, plane(INFINITY)), std::vector<int>(kPixels, 0));
}

TEST(DepthNoise, DeviationGrowsWithTheSquareOfTheDepth) {
  auto parameters = quiet();
  parameters.noiseCoefficient = 0.002;
  auto noise = noiseOf(parameters);
  for (const double depth_mm : {1000.0, 2000.0, 4000.0}) {
    // 2, 8 and 32 mm; rounding to millimetres adds the variance 1/12.
    const double expected = std::hypot(0.002 * depth_mm * depth_mm / 1000.0, std::sqrt(1.0 / 12.0));
    double sum = 0.0, squares = 0.0;
    for (const int value : measured(noise, plane(static_cast<float>(depth_mm / 1000.0)))) {
      sum += value - depth_mm;
      squares += (value - depth_mm) * (value - depth_mm);
    }
    EXPECT_NEAR(sum / kPixels, 0.0, 5.0 * expected / std::sqrt(kPixels));  // 5 sigma of a mean
    EXPECT_NEAR(std::sqrt(squares / kPixels), expected,
                5.0 * expected / std::sqrt(2.0 * kPixels));  // 5 sigma of a deviation
  }
}

TEST(DepthNoise, IsGaussian) {
  auto parameters = quiet();
  parameters.noiseCoefficient = 0.02;  // at 2 m: 80 mm
  auto noise = noiseOf(parameters);
  const auto values = measured(noise, plane(2.0f));
  // Standard normal distribution: 68.27, 95.45 and 99.73 % within 1, 2 and 3 deviations.
  const double shares[] = {0.6827, 0.9545, 0.9973};
  for (int k = 1; k <= 3; ++k) {
    const double share = shares[k - 1];
    const auto within = std::count_if(values.begin(), values.end(),
                                      [k](int value) { return std::abs(value - 2000) < 80 * k; });
    EXPECT_NEAR(static_cast<double>(within), share * kPixels,
                5.0 * std::sqrt(share * (1.0 - share) * kPixels) + 0.005 * kPixels);  // rounding
  }
}

TEST(DepthNoise, NeighboursAndFramesAreIndependent) {
  auto parameters = quiet();
  parameters.noiseCoefficient = 0.02;
  auto noise = noiseOf(parameters);
  const auto first = measured(noise, plane(2.0f)), second = measured(noise, plane(2.0f));
  const auto correlation = [](const std::vector<int>& a, const std::vector<int>& b,
                              std::size_t shift) {
    double sum = 0.0;
    for (std::size_t i = 0; i + shift < kPixels; ++i)
      sum += (a[i] - 2000.0) * (b[i + shift] - 2000.0);
    return sum / (80.0 * 80.0) / kPixels;
  };
  const double bound = 5.0 / std::sqrt(kPixels);  // 5 sigma
  EXPECT_NEAR(correlation(first, first, 0), 1.0, 0.05);
  EXPECT_NEAR(correlation(first, first, 1), 0.0, bound);
  EXPECT_NEAR(correlation(first, first, kColumns), 0.0, bound);
  EXPECT_NEAR(correlation(first, second, 0), 0.0, bound);
}

TEST(DepthNoise, PixelsDropOutAtTheRateAskedFor) {
  auto parameters = quiet();
  parameters.dropoutProbability = 0.1;
  auto noise = noiseOf(parameters);
  const auto values = measured(noise, plane(2.0f));
  // Binomial: 19200 · 0.1 = 1920, deviation sqrt(19200 · 0.1 · 0.9) = 41.6; 5 of them.
  EXPECT_NEAR(static_cast<double>(std::count(values.begin(), values.end(), 0)), 1920.0, 208.0);
  EXPECT_EQ(std::count(values.begin(), values.end(), 2000),
            static_cast<long>(kPixels) - std::count(values.begin(), values.end(), 0));
}

TEST(DepthNoise, DropoutsDoNotChangeTheNoiseOfOtherPixels) {
  auto parameters = quiet();
  parameters.noiseCoefficient = 0.02;
  auto all = noiseOf(parameters);
  parameters.dropoutProbability = 0.3;
  auto some = noiseOf(parameters);
  const auto a = measured(all, plane(2.0f)), b = measured(some, plane(2.0f));
  int compared = 0;
  for (std::size_t i = 0; i < kPixels; ++i)
    if (b[i] > 0) {
      ASSERT_EQ(a[i], b[i]) << i;
      ++compared;
    }
  EXPECT_NEAR(compared, 0.7 * kPixels, 320);  // deviation 63.5; 5 of them
}

TEST(DepthNoise, OnlyPixelsAtAStepDropOutAsEdges) {
  auto parameters = quiet();
  parameters.edgeStep_m = 0.3;
  parameters.edgeDropoutProbability = 1.0;
  auto noise = noiseOf(parameters);
  const auto values = measured(noise, block(0.31f));
  for (std::size_t i = 0; i < kPixels; ++i) ASSERT_EQ(values[i] == 0, atBorder(i)) << i;
  const auto smooth = measured(noise, block(0.29f));
  EXPECT_EQ(std::count(smooth.begin(), smooth.end(), 0), 0);
}

TEST(DepthNoise, EdgeBesideNothingIsAnEdge) {
  auto parameters = quiet();
  parameters.edgeDropoutProbability = 1.0;
  auto noise = noiseOf(parameters);
  const auto values = measured(noise, block(-INFINITY));  // a hole
  for (std::size_t i = 0; i < kPixels; ++i) ASSERT_TRUE(values[i] == 0 || !atBorder(i)) << i;
  EXPECT_EQ(values[0], 4000);
}

TEST(DepthNoise, EdgesDropOutAtTheirRateBesidesTheOthers) {
  auto parameters = quiet();
  parameters.dropoutProbability = 0.2;
  parameters.edgeDropoutProbability = 0.5;
  auto noise = noiseOf(parameters);
  int dropped = 0, border = 0;
  for (int frame = 0; frame < 40; ++frame) {
    const auto values = measured(noise, block(1.0f));
    for (std::size_t i = 0; i < kPixels; ++i)
      if (atBorder(i)) {
        ++border;
        dropped += values[i] == 0 ? 1 : 0;
      }
  }
  // Within, 40 · 20 − 38 · 18 pixels; around, 2 · 40 + 2 · 20: 236 in each of 40 frames. A share of
  // 1 − 0.8 · 0.5 = 0.6 of 9440: 5664, deviation 47.6; 5 of them.
  EXPECT_EQ(border, 9440);
  EXPECT_NEAR(dropped, 5664, 238);
}

TEST(DepthNoise, NoiseMayMoveDepthsOutOfRange) {
  auto parameters = quiet();
  parameters.noiseCoefficient = 0.02;
  parameters.maxRange_m = 2.0;
  auto noise = noiseOf(parameters);
  const auto values = measured(noise, plane(2.0f));
  // Half of them; deviation sqrt(19200/4) = 69; 5 of them, and half a millimetre of 80.
  EXPECT_NEAR(static_cast<double>(std::count(values.begin(), values.end(), 0)), kPixels / 2.0, 400);
  EXPECT_LE(*std::max_element(values.begin(), values.end()), 2000);
}

TEST(DepthNoise, SameStreamGivesTheSameFrames) {
  auto parameters = quiet();
  parameters.noiseCoefficient = 0.002;
  parameters.dropoutProbability = 0.1;
  auto a = noiseOf(parameters), b = noiseOf(parameters), other = noiseOf(parameters, 8);
  for (int frame = 0; frame < 3; ++frame) {
    const auto values = measured(a, plane(3.0f));
    EXPECT_EQ(values, measured(b, plane(3.0f)));
    EXPECT_NE(values, measured(other, plane(3.0f)));
  }
}

}  // namespace
}  // namespace bslnav
