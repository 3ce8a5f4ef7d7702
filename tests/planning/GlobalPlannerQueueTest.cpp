#include <bslnav/planning/AStarQueue.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace bslnav {
namespace {

TEST(AStarQueue, HandsOutEqualKeysLastInFirstOut) {
  AStarQueue queue;
  queue.reset(100, 10);
  for (std::uint32_t item : {1u, 2u, 3u}) queue.push(105, item);
  EXPECT_EQ(queue.pop().item, 3u);
  queue.push(105, 4);
  EXPECT_EQ(queue.pop().item, 4u);
  EXPECT_EQ(queue.pop().item, 2u);
  EXPECT_EQ(queue.pop().item, 1u);
  EXPECT_TRUE(queue.empty());
}

RC_GTEST_PROP(AStarQueue, HandsOutKeysInOrderWhilePushesGoOn, ()) {
  const auto span = *rc::gen::inRange<std::uint64_t>(1, 300);
  const auto firstKey = *rc::gen::inRange<std::uint64_t>(0, 100000);
  const auto steps = *rc::gen::container<std::vector<std::uint64_t>>(
      200, rc::gen::inRange<std::uint64_t>(0, span + 1));
  AStarQueue queue;
  queue.reset(firstKey, span);
  std::vector<std::uint64_t> waiting;  // the oracle
  std::uint64_t last = firstKey;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    waiting.push_back(last + steps[i]);
    queue.push(last + steps[i], static_cast<std::uint32_t>(i));
    if (i % 3 == 0) continue;
    const auto lowest = std::min_element(waiting.begin(), waiting.end());
    last = queue.pop().key;
    RC_ASSERT(last == *lowest);
    waiting.erase(lowest);
  }
  RC_ASSERT(queue.empty() == waiting.empty());
}

}  // namespace
}  // namespace bslnav
