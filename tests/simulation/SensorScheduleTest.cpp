#include <bslnav/simulation/SensorSchedule.h>
#include <gtest/gtest.h>

#include <memory>

namespace bslnav {
namespace {

using Schedule = SensorSchedule<std::shared_ptr<int>>;

TEST(SensorSchedule, IsDueAtMultiplesOfThePeriod) {
  Schedule schedule(10.0, 0.0);
  EXPECT_TRUE(schedule.due(0.0));
  schedule.take(std::make_shared<int>(0), 0.0);
  EXPECT_FALSE(schedule.due(0.09));
  EXPECT_TRUE(schedule.due(0.1));
  schedule.take(std::make_shared<int>(1), 0.13);  // late: the next one is not
  EXPECT_TRUE(schedule.due(0.2));
}

TEST(SensorSchedule, DeliversTheNewestArrivalOnce) {
  Schedule schedule(10.0, 0.15);
  for (int k = 0; k < 2; ++k) schedule.take(std::make_shared<int>(k), 0.1 * k);
  EXPECT_EQ(schedule.deliver(0.14), nullptr);
  for (int k = 2; k < 4; ++k) schedule.take(std::make_shared<int>(k), 0.1 * k);
  EXPECT_EQ(*schedule.deliver(0.36), 2);  // arrivals at 0.15, 0.25, 0.35, 0.45
  EXPECT_EQ(schedule.deliver(0.36), nullptr);
  EXPECT_EQ(*schedule.deliver(0.45), 3);
}

TEST(SensorSchedule, LetsGoOfWhatNobodyAskedFor) {
  Schedule schedule(10.0, 0.2);
  std::vector<std::weak_ptr<int>> taken;
  for (int k = 0; k < 100; ++k) {
    auto measurement = std::make_shared<int>(k);
    taken.push_back(measurement);
    schedule.take(std::move(measurement), 0.1 * k);
  }
  // At 9.9 s the newest that has arrived is of 9.7 s; those of 9.8 and 9.9 s are on their way.
  for (std::size_t k = 0; k < 100; ++k) EXPECT_EQ(taken[k].expired(), k < 97) << k;
}

}  // namespace
}  // namespace bslnav
