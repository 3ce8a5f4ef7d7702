#include <bslnav/blindspot/StandingThings.h>
#include <gtest/gtest.h>

namespace bslnav {
namespace {

CostGrid place(double xMin_m = -2.0) { return CostGrid(80, 80, 0.05, xMin_m, -2.0, 0); }

TEST(StandingThings, AreNearWhereTheyWereAdded) {
  StandingThings things;
  things.follow(place());
  things.add({0.0, 0.0}, {1.0, 0.0});
  EXPECT_TRUE(things.isNear({0.5, 0.08}, 0.1));
  EXPECT_FALSE(things.isNear({0.5, 0.3}, 0.1));
  EXPECT_FALSE(things.isNear({-0.3, 0.0}, 0.1));
}

TEST(StandingThings, StayInTheMapWhenTheRobotMoves) {
  StandingThings things;
  things.follow(place());
  things.add({0.5, 0.5}, {0.5, 0.5});
  things.follow(place(-1.0));
  EXPECT_TRUE(things.isNear({0.5, 0.5}, 0.0));
  EXPECT_FALSE(things.isNear({1.5, 0.5}, 0.0));
}

/** Noise lets a beam end a cell behind a wall; a wall that is gone is seen through. */
TEST(StandingThings, AreForgottenWhereItIsEmptyAllAround) {
  StandingThings things;
  things.follow(place());
  things.add({0.5, 0.5}, {0.5, 0.5});
  CostGrid empty = place();
  const int x = empty.cellX(0.5), y = empty.cellY(0.5);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 0; ++dx) empty.at(x + dx, y + dy) = 255;
  things.forget(empty);
  EXPECT_TRUE(things.isNear({0.5, 0.5}, 0.0));
  for (int dy = -1; dy <= 1; ++dy) empty.at(x + 1, y + dy) = 255;
  things.forget(empty);
  EXPECT_FALSE(things.isNear({0.5, 0.5}, 0.0));
}

}  // namespace
}  // namespace bslnav
