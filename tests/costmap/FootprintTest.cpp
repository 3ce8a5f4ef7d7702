#include <bslnav/config/Error.h>
#include <bslnav/costmap/Footprint.h>
#include <gtest/gtest.h>

namespace bslnav {
namespace {

Footprint rectangle() {
  Footprint footprint;
  footprint.polygon = {{0.4, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.4, -0.2}};
  return footprint;
}

TEST(Footprint, RadiiOfARectangle) {
  EXPECT_DOUBLE_EQ(rectangle().inscribedRadius_m(), 0.2);  // to the sides and to the rear
  EXPECT_DOUBLE_EQ(rectangle().circumscribedRadius_m(),
                   std::hypot(0.4, 0.2));  // to the front corners
}

TEST(Footprint, RectangleContainsItsInsideOnly) {
  EXPECT_TRUE(rectangle().contains({0.39, 0.19}));
  EXPECT_FALSE(rectangle().contains({0.41, 0.0}));
  EXPECT_FALSE(rectangle().contains({-0.21, 0.0}));
}

TEST(Footprint, CircleContainsItsRadius) {
  Footprint circle;
  circle.radius_m = 0.3;
  EXPECT_TRUE(circle.contains({0.0, 0.3}));
  EXPECT_FALSE(circle.contains({0.22, 0.22}));
}

TEST(Footprint, RefusesAPolygonBesideTheCentre) {
  Footprint footprint;
  footprint.polygon = {{1.0, 0.0}, {2.0, 0.0}, {1.5, 1.0}};
  EXPECT_THROW(footprint.check(), Error);
}

}  // namespace
}  // namespace bslnav
