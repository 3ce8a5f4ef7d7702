#include <bslnav/simulation/RandomStream.h>

namespace bslnav {

mrpt::random::CRandomGenerator randomStream(std::uint64_t seed, const std::string& source) {
  // FNV-1a over the name, then the finaliser of SplitMix64, which spreads neighbouring seeds.
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : source) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  hash += seed * 0x9e3779b97f4a7c15ULL;
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9ULL;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebULL;
  return mrpt::random::CRandomGenerator(static_cast<std::uint32_t>(hash >> 32));
}

}  // namespace bslnav
