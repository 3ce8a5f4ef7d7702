#include <bslnav/evaluation/ParallelWork.h>
#include <gmock/gmock.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace bslnav {
namespace {

class ParallelWork : public testing::TestWithParam<int> {};

TEST_P(ParallelWork, DoesEveryPieceOnceAndReportsInOrder) {
  std::vector<int> times(100, 0);
  std::vector<std::size_t> reported;
  WorkWatch watch;
  watch.progress = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 100u);
    reported.push_back(done);
  };
  const std::size_t done = doInParallel(
      100, GetParam(), [&times](std::size_t i) { ++times[i]; }, watch);
  EXPECT_EQ(done, 100u);
  EXPECT_THAT(times, testing::Each(1));
  std::vector<std::size_t> inOrder(100);
  std::iota(inOrder.begin(), inOrder.end(), 1u);
  EXPECT_EQ(reported, inOrder);
}

TEST_P(ParallelWork, AfterAStopTheFirstPiecesAreDoneAndNoOthers) {
  std::vector<int> times(100, 0);
  int asked = 0;
  WorkWatch watch;
  watch.goOn = [&asked] { return ++asked <= 10; };
  EXPECT_EQ(doInParallel(
                100, GetParam(), [&times](std::size_t i) { ++times[i]; }, watch),
            10u);
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_EQ(times[i], i < 10 ? 1 : 0) << i;
}

TEST_P(ParallelWork, WhatAPieceThrowsComesOut) {
  const auto work = [](std::size_t i) {
    if (i == 7) throw std::runtime_error("seven");
  };
  EXPECT_THROW(doInParallel(100, GetParam(), work), std::runtime_error);
}

TEST_P(ParallelWork, NothingToDoIsDoneAtOnce) {
  EXPECT_EQ(doInParallel(0, GetParam(), [](std::size_t) { FAIL(); }), 0u);
}

INSTANTIATE_TEST_SUITE_P(Jobs, ParallelWork, testing::Values(0, 1, 2), [](const auto& test) {
  return test.param == 0 ? std::string("OneACore") : "Jobs" + std::to_string(test.param);
});

}  // namespace
}  // namespace bslnav
