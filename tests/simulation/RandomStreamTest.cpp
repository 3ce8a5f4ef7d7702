#include <bslnav/simulation/RandomStream.h>
#include <gtest/gtest.h>

namespace bslnav {
namespace {

std::uint32_t firstNumber(std::uint64_t seed, const std::string& source) {
  return randomStream(seed, source).drawUniform32bit();
}

TEST(RandomStream, SameSeedAndSourceGiveTheSameNumbers) {
  EXPECT_EQ(firstNumber(1, "laser"), firstNumber(1, "laser"));
}

TEST(RandomStream, OtherSourceGivesOtherNumbers) {
  EXPECT_NE(firstNumber(1, "laser"), firstNumber(1, "odometry"));
}

TEST(RandomStream, OtherSeedGivesOtherNumbers) {
  EXPECT_NE(firstNumber(1, "laser"), firstNumber(2, "laser"));
  EXPECT_NE(firstNumber(1, "laser"), firstNumber(1 + (1ULL << 32), "laser"));  // all 64 bits count
}

}  // namespace
}  // namespace bslnav
