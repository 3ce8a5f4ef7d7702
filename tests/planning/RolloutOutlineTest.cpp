#include <bslnav/planning/Rollout.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "DwaGenerators.h"

namespace bslnav {
namespace {

using mrpt::math::TPose2D;
using test::any;
using test::anySetup;
using test::onArc;

constexpr double kCell_m = 0.05;

FootprintCover circle() { return FootprintCover({}, kCell_m, test::noInflation()); }

/** A footprint that grows by `outwards_m` holds the pole at some moment of the drive. */
bool sweeps(const Footprint& footprint, double v, double w, const RolloutSetup& setup, double poleX,
            double poleY, double outwards_m) {
  Footprint grown = footprint;
  for (auto& corner : grown.polygon) {
    corner.x += outwards_m * std::copysign(1.0, corner.x);
    corner.y += outwards_m * std::copysign(1.0, corner.y);
  }
  for (int i = 1; i <= 1000; ++i) {
    const TPose2D pose = onArc(setup.start, v, w, i * setup.horizon_s / 1000);
    const double dx = poleX - pose.x, dy = poleY - pose.y;
    const double c = std::cos(pose.phi), s = std::sin(pose.phi);
    if (grown.contains({c * dx + s * dy, c * dy - s * dx})) return true;
  }
  return false;
}

RC_GTEST_PROP(RolloutLaw, OfARectangleMeetsAThinPoleExactlyWhenItsSweepDoes, ()) {
  const Footprint footprint = test::rectangle(any(0.3, 0.8), any(0.3, 0.6));
  const FootprintCover cover(footprint, kCell_m, test::noInflation());
  CostGrid grid(160, 160, kCell_m, -4.0, -4.0);
  RolloutSetup setup = anySetup();
  setup.start.x = setup.start.y = 0.0;
  setup.outlineReach_m = cover.reach_m();
  const double v = any(0.0, 0.8), w = any(-1.0, 1.0), distance = any(0.1, 2.0),
               aside = any(-1.5, 1.5);
  const int x = grid.cellX(distance * std::cos(setup.start.phi + aside));
  const int y = grid.cellY(distance * std::sin(setup.start.phi + aside));
  const double poleX = grid.idx2x(x), poleY = grid.idx2y(y);
  RolloutSetup atStart = setup;
  atStart.horizon_s = 1e-6;
  RC_PRE(!sweeps(footprint, v, w, atStart, poleX, poleY, kCell_m));  // begins in the free
  grid.at(x, y) = kLethalCost;
  const bool blocked = rollOut(v, w, setup, grid, cover).blocked();
  RC_CLASSIFY(blocked, "blocked");
  // Steps of at most a cell may miss a graze of half a cell; a cell reaches 0.71 cells from its
  // centre.
  if (sweeps(footprint, v, w, setup, poleX, poleY, -0.5 * kCell_m)) RC_ASSERT(blocked);
  if (blocked) RC_ASSERT(sweeps(footprint, v, w, setup, poleX, poleY, 0.72 * kCell_m));
}

RC_GTEST_PROP(RolloutLaw, OfA32GonIsThatOfTheCircle, ()) {
  constexpr double kRadius_m = 0.3;
  Footprint polygon;
  for (int i = 0; i < 32; ++i)
    polygon.polygon.emplace_back(kRadius_m * std::cos(i * M_PI / 16),
                                 kRadius_m * std::sin(i * M_PI / 16));
  const CostGrid base = test::scattered(12);
  const InflationLayer round({0.55, 10.0}, kRadius_m, kCell_m);
  const InflationLayer cornered({0.55, 10.0}, polygon.inscribedRadius_m(), kCell_m);
  const FootprintCover cover(polygon, kCell_m, cornered);
  RolloutSetup setup = anySetup();
  setup.outlineReach_m = cover.reach_m();
  const double v = any(0.0, 0.8), w = any(-1.0, 1.0);
  const bool asPolygon = rollOut(v, w, setup, test::inflated(base, cornered), cover).blocked();
  const bool asCircle = rollOut(v, w, setup, test::inflated(base, round), circle()).blocked();
  double nearest = 1e9;
  for (int i = 1; i <= 200; ++i) {
    const TPose2D pose = onArc(setup.start, v, w, i * setup.horizon_s / 200);
    for (int y = 0; y < base.height(); ++y)
      for (int x = 0; x < base.width(); ++x)
        if (base.at(x, y) == kLethalCost)
          nearest = std::min(nearest, std::hypot(base.idx2x(x) - pose.x, base.idx2y(y) - pose.y));
  }

  RC_CLASSIFY(asCircle, "blocked");
  if (nearest > kRadius_m + 1.5 * kCell_m) RC_ASSERT(asPolygon == asCircle);
  if (nearest < kRadius_m - 1.5 * kCell_m) RC_ASSERT((asPolygon && asCircle));
}

}  // namespace
}  // namespace bslnav
