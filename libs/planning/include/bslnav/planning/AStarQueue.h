#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bslnav {

/** A monotone priority queue for integer keys (Dial 1969): a ring of buckets, each a stack.
 *
 * Keys may be pushed in any order as long as each lies within `span` of the key popped last and not
 * below it. Equal keys come out last in, first out. Buffers are kept between searches. */
class AStarQueue {
 public:
  struct Entry {
    std::uint64_t key;
    std::uint32_t item;
  };

  /** Empties the queue. @param firstKey no key will be below it @param span most that a key may
   * exceed the key popped last */
  void reset(std::uint64_t firstKey, std::uint64_t span);

  bool empty() const { return size_ == 0; }

  void push(std::uint64_t key, std::uint32_t item) {
    const std::size_t slot = key & mask_;
    std::uint32_t entry = free_;
    if (entry == kNone) {
      entry = static_cast<std::uint32_t>(pool_.size());
      pool_.push_back({item, head_[slot]});
    } else {
      free_ = pool_[entry].next;
      pool_[entry] = {item, head_[slot]};
    }
    head_[slot] = entry;
    occupied_[slot / 64] |= std::uint64_t{1} << (slot % 64);
    ++size_;
  }

  /** Takes an entry with the lowest key; the queue must not be empty. */
  Entry pop() {
    const std::size_t slot = nextOccupied(lowest_ & mask_);
    lowest_ += (slot - lowest_) & mask_;
    const std::uint32_t entry = head_[slot];
    const std::uint32_t item = pool_[entry].item;
    head_[slot] = pool_[entry].next;
    if (head_[slot] == kNone) occupied_[slot / 64] &= ~(std::uint64_t{1} << (slot % 64));
    pool_[entry].next = free_;
    free_ = entry;
    --size_;
    return {lowest_, item};
  }

 private:
  struct Link {
    std::uint32_t item, next;
  };
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  /** First occupied slot at or after `slot` around the ring. */
  std::size_t nextOccupied(std::size_t slot) const;

  std::vector<Link> pool_;
  std::vector<std::uint32_t> head_;      ///< top of each bucket's stack
  std::vector<std::uint64_t> occupied_;  ///< one bit a bucket
  std::uint64_t lowest_ = 0;
  std::size_t mask_ = 0, size_ = 0;
  std::uint32_t free_ = kNone;
};

}  // namespace bslnav
