#pragma once

#include <mrpt/random/RandomGenerators.h>

#include <utility>

namespace bslnav {

/** As long as it lives, MRPT's algorithms draw from a generator of ours in this thread.
 *
 * They know only mrpt::random::getRandomGenerator(), one a thread: both generators change places,
 * and change back whatever happens in between. */
class OwnGenerator {
 public:
  explicit OwnGenerator(mrpt::random::CRandomGenerator& own) : own_(own) {
    std::swap(own_, mrpt::random::getRandomGenerator());
  }
  ~OwnGenerator() { std::swap(own_, mrpt::random::getRandomGenerator()); }
  OwnGenerator(const OwnGenerator&) = delete;
  OwnGenerator& operator=(const OwnGenerator&) = delete;

 private:
  mrpt::random::CRandomGenerator& own_;
};

}  // namespace bslnav
