#pragma once

#include <cstddef>
#include <vector>

namespace bslnav {

/** Which cycles of a drive are kept, so that the memory of one that never ends stays bounded: all
 * of them, then every second one, every fourth and so on. */
class Thinning {
 public:
  static constexpr std::size_t kMost = 8192;  ///< that are kept; the longest test has fewer

  /** To be asked once a cycle. */
  bool keepsNext() { return seen_++ % every_ == 0; }
  /** To be told how many are kept; returns whether every second one has to go. */
  bool isFull(std::size_t kept) {
    if (kept < kMost) return false;
    every_ *= 2;
    return true;
  }

  /** Drops every second one, the first stays. */
  template <class T>
  static void halve(std::vector<T>& kept) {
    for (std::size_t i = 1; 2 * i < kept.size(); ++i) kept[i] = kept[2 * i];
    kept.resize((kept.size() + 1) / 2);
  }

 private:
  std::size_t seen_ = 0, every_ = 1;
};

}  // namespace bslnav
