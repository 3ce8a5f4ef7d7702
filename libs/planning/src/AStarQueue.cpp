#include <bslnav/planning/AStarQueue.h>

namespace bslnav {

void AStarQueue::reset(std::uint64_t firstKey, std::uint64_t span) {
  std::size_t buckets = 64;
  while (buckets <= span) buckets *= 2;
  head_.assign(buckets, kNone);
  occupied_.assign(buckets / 64, 0);
  pool_.clear();
  mask_ = buckets - 1;
  lowest_ = firstKey;
  size_ = 0;
  free_ = kNone;
}

std::size_t AStarQueue::nextOccupied(std::size_t slot) const {
  std::size_t word = slot / 64;
  std::uint64_t bits = occupied_[word] & (~std::uint64_t{0} << (slot % 64));
  while (bits == 0) {
    word = (word + 1) % occupied_.size();
    bits = occupied_[word];
  }
  return word * 64 + static_cast<std::size_t>(__builtin_ctzll(bits));
}

}  // namespace bslnav
