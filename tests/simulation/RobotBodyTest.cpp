#include <bslnav/config/Error.h>
#include <bslnav/simulation/RobotBody.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "TestWorld.h"

namespace bslnav {
namespace {

using mrpt::math::TPose2D;

const RobotOutline kRectangle{{{0.4, 0.2}, {-0.4, 0.2}, {-0.4, -0.2}, {0.4, -0.2}}, 0.0, 1.0};
/** An L: the square [-0.5, 0.5]² without its quarter x > 0, y > 0. */
const RobotOutline kConcave{
    {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.0}, {0.0, 0.0}, {0.0, 0.5}, {-0.5, 0.5}}, 0.0, 1.0};

RobotBody at(const TPose2D& pose, const RobotOutline& outline) {
  RobotBody body(outline);
  body.moveTo(pose);
  return body;
}

WorldShape boxShape(const TPose2D& pose, double length_m, double width_m, double zMin_m = 0.0) {
  WorldParameters world;
  world.boxes["b"] = test::box(pose, length_m, width_m, zMin_m, zMin_m + 1.0);
  return worldShapes(world).front();
}

TEST(RobotBody, CircleToCircle) {
  EXPECT_NEAR(at({1, 1, 0.3}, {{}, 0.3, 1.0}).clearanceTo({4, 5}, 0.25), 5.0 - 0.3 - 0.25, 1e-12);
}

TEST(RobotBody, CircleToBoxCorner) {
  // Corner (3.5, 4.5) of a box at (4, 5): 3-4-5 triangle with (0.5, 0.5).
  EXPECT_NEAR(at({0.5, 0.5, 0}, {{}, 0.3, 1.0}).clearanceTo(boxShape({4, 5, 0}, 1, 1)), 5.0 - 0.3,
              1e-12);
}

TEST(RobotBody, TurnedRectangleToCircle) {
  // Heading 90°: the front edge is at y = 0.4, the circle's nearest point at y = 1 - 0.25.
  EXPECT_NEAR(at({0, 0, M_PI / 2}, kRectangle).clearanceTo({0, 1}, 0.25), 0.35, 1e-12);
}

TEST(RobotBody, RectangleCornerToBoxFace) {
  // Heading 45°: corners (0.4, ±0.2) reach x = (0.4 + 0.2)/sqrt(2) towards the face at x = 1.
  EXPECT_NEAR(at({0, 0, M_PI / 4}, kRectangle).clearanceTo(boxShape({1.5, 0, 0}, 1, 4)),
              1.0 - 0.6 / std::sqrt(2.0), 1e-12);
}

TEST(RobotBody, CircleInTheNotchOfAConcaveOutlineIsClear) {
  // From (0.3, 0.3) both edges of the notch are 0.3 away.
  EXPECT_NEAR(at({0, 0, 0}, kConcave).clearanceTo({0.3, 0.3}, 0.1), 0.2, 1e-12);
}

TEST(RobotBody, BoxInTheNotchOfAConcaveOutlineIsClear) {
  EXPECT_NEAR(at({0, 0, 0}, kConcave).clearanceTo(boxShape({0.3, 0.3, 0}, 0.2, 0.2)), 0.2, 1e-12);
}

TEST(RobotBody, ContactWhenOneOutlineHoldsTheOther) {
  EXPECT_LE(at({0, 0, 0}, kRectangle).clearanceTo({0, 0}, 0.05), 0.0);
  EXPECT_LE(at({0, 0, 0}, kRectangle).clearanceTo(boxShape({0, 0, 0}, 0.1, 0.1)), 0.0);
  EXPECT_LE(at({0, 0, 0}, kRectangle).clearanceTo(boxShape({0, 0, 0}, 5, 5)), 0.0);
}

TEST(RobotBody, ContactWhenOutlinesCrossWithoutCornersInside) {
  EXPECT_LE(at({0, 0, 0}, kRectangle).clearanceTo(boxShape({0, 0, 0}, 0.1, 3)), 0.0);
}

TEST(RobotBody, SolidAboveTheRobotIsNoObstacle) {
  const auto body = at({0, 0, 0}, kRectangle);
  EXPECT_TRUE(std::isinf(body.clearanceTo(boxShape({0, 0, 0}, 1, 1, 1.0))));
  EXPECT_LE(body.clearanceTo(boxShape({0, 0, 0}, 1, 1, 0.9)), 0.0);
}

TEST(RobotBody, OutlineOfTwoCornersIsRefused) {
  EXPECT_THROW(RobotBody({{{0, 0}, {1, 0}}, 0.2, 1.0}), Error);
}

RC_GTEST_PROP(RobotBody, NearestOfManyEqualsTheSmallestOfAll, ()) {
  const auto number = [](int low, int high) { return *rc::gen::inRange(low, high) / 100.0; };
  std::vector<WorldShape> shapes;
  for (int i = 0; i < 6; ++i)
    shapes.push_back(boxShape({number(-300, 300), number(-300, 300), number(-314, 314)},
                              number(5, 200), number(5, 200)));
  const auto body = at({number(-300, 300), number(-300, 300), number(-314, 314)}, kRectangle);
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& shape : shapes) smallest = std::min(smallest, body.clearanceTo(shape));
  RC_ASSERT(body.clearanceTo(shapes) == smallest);
}

RC_GTEST_PROP(RobotBody, MovingByADistanceChangesTheClearanceByNoMore, ()) {
  const auto number = [](int low, int high) { return *rc::gen::inRange(low, high) / 100.0; };
  const auto shape = boxShape({0, 0, number(-314, 314)}, number(5, 200), number(5, 200));
  const TPose2D from(number(-300, 300), number(-300, 300), number(-314, 314));
  const double dx = number(-100, 100), dy = number(-100, 100);
  const double a = at(from, kConcave).clearanceTo(shape);
  const double b = at({from.x + dx, from.y + dy, from.phi}, kConcave).clearanceTo(shape);
  RC_ASSERT(std::abs(a - b) <= std::hypot(dx, dy) + 1e-9);
}

}  // namespace
}  // namespace bslnav
