#include <bslnav/planning/FootprintCover.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "DwaGenerators.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;
using test::any;

constexpr double kCell_m = 0.05;

/** A rectangle, a wedge or an L around the robot's centre. */
Footprint anyFootprint() {
  const double a = any(0.12, 0.5), b = any(0.12, 0.4);
  const Footprint shapes[] = {
      test::rectangle(2 * a, 2 * b),
      {0.0, {{a, 0.0}, {-a, b}, {-0.8 * a, -b}}},
      {0.0, {{a, b}, {-a, b}, {-a, -b}, {0.1, -b}, {0.1, -0.1}, {a, -0.1}}}};
  return shapes[*rc::gen::inRange(0, 3)];
}

double distanceToOutline(const Footprint& footprint, const TPoint2D& p) {
  double nearest = 1e9;
  for (std::size_t i = 0; i < footprint.polygon.size(); ++i) {
    const TPoint2D a = footprint.polygon[i];
    const TPoint2D ab = footprint.polygon[(i + 1) % footprint.polygon.size()] - a;
    for (int k = 0; k <= 1000; ++k) nearest = std::min(nearest, (a + ab * (k / 1000.0) - p).norm());
  }
  return nearest;
}

/** A robot somewhere near the middle of a grid of 40×40 cells, and one lethal cell. */
struct Meeting {
  CostGrid grid{40, 40, kCell_m, 0.0, 0.0};
  double x, y, heading;
  int poleX, poleY;

  Meeting()
      : x(any(18.0, 22.0)),
        y(any(18.0, 22.0)),
        heading(any(-M_PI, M_PI)),
        poleX(*rc::gen::resize(rc::kNominalSize, rc::gen::inRange(8, 32))),
        poleY(*rc::gen::resize(rc::kNominalSize, rc::gen::inRange(8, 32))) {
    grid.at(poleX, poleY) = kLethalCost;
  }
  TPoint2D poleFromRobot() const {
    const double dx = (poleX + 0.5 - x) * kCell_m, dy = (poleY + 0.5 - y) * kCell_m;
    return {std::cos(heading) * dx + std::sin(heading) * dy,
            std::cos(heading) * dy - std::sin(heading) * dx};
  }
  bool touchedBy(const FootprintCover& cover, const CostGrid& costs) const {
    return cover.touches(
        costs, static_cast<float>(x), static_cast<float>(y), static_cast<float>(std::cos(heading)),
        static_cast<float>(std::sin(heading)), costs.at(static_cast<int>(x), static_cast<int>(y)));
  }
};

TEST(FootprintCover, OfACircleIsEmpty) {
  const FootprintCover cover({}, kCell_m, test::noInflation());
  EXPECT_TRUE(cover.empty());
  EXPECT_EQ(cover.reach_m(), 0.0);
}

RC_GTEST_PROP(FootprintCoverLaw, TouchesEveryCellWithItsCentreInsideAndNoneFarOutside, ()) {
  const Footprint footprint = anyFootprint();
  const FootprintCover cover(footprint, kCell_m, test::noInflation());
  const Meeting meeting;
  const TPoint2D pole = meeting.poleFromRobot();
  const bool touched = meeting.touchedBy(cover, meeting.grid);
  RC_CLASSIFY(touched, "touched");
  // A point is within 0.5 cells of the centre; nearer than two cells inside the inscribed circle
  // are none.
  if (footprint.contains(pole) && pole.norm() > footprint.inscribedRadius_m() - 1.5 * kCell_m)
    RC_ASSERT(touched);
  // A cell's corner is 0.71 cells from its centre.
  if (touched && !footprint.contains(pole))
    RC_ASSERT(distanceToOutline(footprint, pole) <= 0.72 * kCell_m);
}

RC_GTEST_PROP(FootprintCoverLaw, WhatInflationTellsChangesNothing, ()) {
  const Footprint footprint = anyFootprint();
  const Meeting meeting;
  const InflationLayer inflation({any(0.0, 0.8), any(0.0, 10.0)}, footprint.inscribedRadius_m(),
                                 kCell_m);
  const FootprintCover every(footprint, kCell_m, test::noInflation());
  const FootprintCover near(footprint, kCell_m, inflation);
  const CostGrid costs = test::inflated(meeting.grid, inflation);
  RC_CLASSIFY(meeting.touchedBy(every, costs), "touched");
  RC_ASSERT(meeting.touchedBy(near, costs) == meeting.touchedBy(every, costs));
}

TEST(FootprintCover, IgnoresWhatIsOffTheGrid) {
  const CostGrid grid(4, 4, kCell_m, 0.0, 0.0);
  const FootprintCover cover(test::rectangle(1.0, 1.0), kCell_m, test::noInflation());
  EXPECT_FALSE(cover.touches(grid, 2.0f, 2.0f, 1.0f, 0.0f, kFreeCost));
}

}  // namespace
}  // namespace bslnav
