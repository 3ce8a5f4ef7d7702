#include <bslnav/planning/MoverForecast.h>
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

namespace bslnav {
namespace {

/** One person at 2 m to the left of the line ahead, who crosses it `ahead_m` before the robot. */
Movers crossing(double ahead_m, double speed_mps = 1.0) {
  return {{{ahead_m, 2.0}, {0.0, -speed_mps}}};
}

MoverForecast forecastOf(const Movers& movers, const mrpt::math::TPose2D& pose = {}) {
  MoverForecast forecast({}, {0.25, 0.5, 0.2}, {});
  forecast.begin(pose, movers);
  return forecast;
}

TEST(MoverForecast, NobodyWalkingCostsNothing) {
  EXPECT_EQ(forecastOf({}).cost({0.5, 0.0, 0.3}), 0.0);
}

TEST(MoverForecast, StandingClearOfThemCostsNothingAndDrivingIntoTheirWayDoes) {
  const auto forecast = forecastOf(crossing(1.2));
  EXPECT_EQ(forecast.cost({0.0, 0.0, 0.0}), 0.0);
  EXPECT_GT(forecast.cost({1.0, 0.0, 0.0}), 1.0);  // it cannot stop before their way any more
  EXPECT_LT(forecast.cost({0.1, 0.0, 0.0}), 1.0);
}

/** At 0.5 m/s it stands 0.35 m further on: soon enough to stop then, if they still come. */
TEST(MoverForecast, WhoCanStillStopBeforeTheirWayIsNotInIt) {
  EXPECT_EQ(forecastOf(crossing(1.4)).cost({0.5, 0.0, 0.0}), 0.0);
  EXPECT_GT(forecastOf(crossing(1.2)).cost({0.5, 0.0, 0.0}), 0.0);
}

TEST(MoverForecast, StandingInTheirWayCostsMoreThanLeavingIt) {
  const auto forecast = forecastOf(crossing(0.0));
  EXPECT_GT(forecast.cost({0.0, 0.0, 0.0}), 1.0);
  EXPECT_LT(forecast.cost({0.5, 0.0, 0.0}), forecast.cost({0.0, 0.0, 0.0}));
}

/** Where meeting them cannot be helped, a way that leaves less of the robot in theirs is better. */
TEST(MoverForecast, TheDeeperInTheirWayTheWorse) {
  EXPECT_GT(forecastOf(crossing(0.0)).cost({}), forecastOf(crossing(0.3)).cost({}));
  EXPECT_GT(forecastOf(crossing(0.3)).cost({}), forecastOf(crossing(0.5)).cost({}));
}

TEST(MoverForecast, WhoWalksAwayIsNoConcern) {
  EXPECT_EQ(forecastOf({{{1.2, 0.0}, {1.0, 0.0}}}).cost({0.5, 0.0, 0.0}), 0.0);
}

RC_GTEST_PROP(MoverForecast, DoesNotDependOnTheFrameOfTheMap, ()) {
  const auto any = [](double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1000) / 1000.0;
  };
  const mrpt::math::TPose2D frame{any(-3, 3), any(-3, 3), any(-3, 3)};
  const Mover mover{{any(-3, 3), any(-3, 3)}, {any(-1, 1), any(-1, 1)}};
  const mrpt::math::TPose2D turn{0.0, 0.0, frame.phi};
  const Mover moved{frame.composePoint(mover.position), turn.composePoint(mover.velocity)};
  const mrpt::math::TTwist2D command{any(-0.5, 0.5), any(-0.3, 0.3), any(-1, 1)};
  RC_ASSERT(std::abs(forecastOf({mover}).cost(command) - forecastOf({moved}, frame).cost(command)) <
            1e-3);
}

}  // namespace
}  // namespace bslnav
