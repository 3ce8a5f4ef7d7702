#pragma once

#include <bslnav/simulation/RandomStream.h>

#include <cstdint>
#include <string>

namespace bslnav {

/** What an encounter is drawn with: one stream of random numbers. */
class Dice {
 public:
  Dice(std::uint64_t seed, const std::string& source) : random_(randomStream(seed, source)) {}

  double between(double low, double high) { return random_.drawUniform(low, high); }
  bool chance(double probability) { return random_.drawUniform(0.0, 1.0) < probability; }
  /** @returns from `low` to `high`, both included */
  int whole(int low, int high) {
    const auto span = static_cast<std::uint32_t>(high - low + 1);
    return low + static_cast<int>(random_.drawUniform32bit() % span);
  }
  /** 1 or -1. */
  double side() { return chance(0.5) ? 1.0 : -1.0; }
  std::uint64_t seed() { return random_.drawUniform32bit(); }

 private:
  mrpt::random::CRandomGenerator random_;
};

}  // namespace bslnav
