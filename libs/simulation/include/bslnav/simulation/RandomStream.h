#pragma once

#include <mrpt/random/RandomGenerators.h>

#include <cstdint>
#include <string>

namespace bslnav {

/** The random numbers of one noise source, from the run's seed and the source's name only.
 *
 * Adding a source therefore leaves the others as they were. */
mrpt::random::CRandomGenerator randomStream(std::uint64_t seed, const std::string& source);

}  // namespace bslnav
