// Shelves, boxes, pillars and crowds.
#include <algorithm>
#include <cmath>

#include "EncounterBuilder.h"

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

/** A hall without openings. */
void hall(EncounterBuilder& builder, double half_m, double length_m) {
  CorridorPlan plan;
  plan.length_m = length_m;
  plan.right_m = plan.left_m = half_m;
  builder.corridor(plan);
}

}  // namespace

void buildAisles(EncounterBuilder& builder) {
  Dice& dice = builder.dice();
  constexpr double kHalf_m = 3.0, kShelf_m = 0.5;
  hall(builder, kHalf_m, 9.5);
  const double side = dice.between(0.95, 1.3);  // from the robot's line to the shelves
  std::vector<double> gaps;
  double x = dice.between(0.4, 1.2);
  for (int i = 0; i < 3; ++i) {
    const double length = dice.between(1.2, 1.9), gap = dice.between(0.9, 1.2);
    for (const double way : {-1.0, 1.0}) {
      BoxParameters shelf;
      shelf.pose = {x + 0.5 * length, way * (side + 0.5 * kShelf_m), 0.0};
      shelf.length_m = length;
      shelf.width_m = kShelf_m;
      shelf.zMax_m = 1.8;
      builder.box(shelf);
    }
    gaps.push_back(x + length + 0.5 * gap);
    x += length + gap;
  }
  const double gap = gaps[static_cast<std::size_t>(dice.whole(0, 2))];
  // From behind a shelf through the gap, and through the one on the other side.
  const double behind = -(side + kShelf_m + 0.6);
  const TPoint2D from(gap - dice.between(0.0, 1.0), behind), corner(gap, behind);
  builder.person({from, {corner.x + 0.01, corner.y}, {gap, -behind}},
                 {gap, corner.x - from.x - behind});
  builder.encounter().goals = {{7.5, 0.0, 0.0}};
}

void buildBoxes(EncounterBuilder& builder) {
  Dice& dice = builder.dice();
  CorridorPlan plan;
  plan.length_m = 9.0;
  plan.right_m = dice.between(1.2, 1.7);
  plan.left_m = dice.between(1.1, 1.6);
  builder.corridor(plan);
  double meetAt = 0.0;
  for (int i = 0; i < 2; ++i) {
    BoxParameters parked;
    parked.length_m = dice.between(0.6, 1.2);
    parked.width_m = dice.between(0.5, 0.7);
    parked.zMax_m = dice.between(0.9, 1.7);
    parked.pose = {2.2 + 2.6 * i + dice.between(-0.3, 0.3),
                   -plan.right_m + 0.06 + 0.5 * parked.width_m, 0.0};
    parked.mapped = false;
    builder.box(parked);
    if (i == 0 || dice.chance(0.5)) meetAt = parked.pose.x + 0.5 * parked.length_m + 0.4;
  }
  const double from = -plan.right_m + 0.4;
  builder.person({{meetAt, from}, {meetAt + dice.between(-0.3, 0.3), plan.left_m - 0.4}},
                 {meetAt, -from});
  builder.encounter().goals = {{7.5, 0.0, 0.0}};
}

void buildPillars(EncounterBuilder& builder) {
  Dice& dice = builder.dice();
  constexpr double kHalf_m = 2.6;
  hall(builder, kHalf_m, 9.5);
  const double row = dice.between(0.95, 1.4);
  std::vector<TPoint2D> hidden;
  for (int i = 0; i < 4; ++i)
    for (const double side : {-1.0, 1.0}) {
      CylinderParameters pillar;
      pillar.x_m = 1.5 + 1.6 * i + dice.between(-0.08, 0.08);
      pillar.y_m = side * row;
      pillar.radius_m = dice.between(0.2, 0.35);
      builder.cylinder(pillar);
      hidden.emplace_back(pillar.x_m + 0.4, side * (row + pillar.radius_m + 0.35));
    }
  for (int i = dice.whole(1, 2); i > 0; --i) {
    // From beside a pillar through the middle between two pillars to the other side.
    const TPoint2D from = hidden[static_cast<std::size_t>(dice.whole(1, 5))];
    const double x = from.x + 0.4, side = from.y > 0.0 ? 1.0 : -1.0;
    builder.person({from, {x, from.y * 0.98}, {x, -side * (kHalf_m - 0.4)}},
                   {x, std::abs(from.y) + 0.4});
  }
  builder.encounter().goals = {{7.5, 0.0, 0.0}};
}

/** Where people stand, before and after, they stand beside each other and not in each other. */
void buildCrowd(EncounterBuilder& builder) {
  Dice& dice = builder.dice();
  constexpr double kApart_m = 0.6;
  const double half = dice.between(2.5, 3.5);
  const double reach = half - 0.4;
  hall(builder, half, 9.5);
  std::vector<TPoint2D> taken;
  const auto isTaken = [&taken](const TPoint2D& place) {
    return std::any_of(taken.begin(), taken.end(),
                       [&place](const TPoint2D& p) { return (p - place).norm() < kApart_m; });
  };
  for (int i = dice.whole(3, 5); i > 0;) {
    const double side = dice.side(), meetAt = dice.between(1.5, 6.5);
    const double slant = dice.between(-1.0, 1.0);
    const TPoint2D from(meetAt - slant * reach * 0.5, side * reach);
    const TPoint2D to(meetAt + slant * reach * 0.5, -side * reach);
    if (isTaken(from) || isTaken(to)) continue;
    builder.person({from, to}, {meetAt, reach * std::hypot(1.0, 0.5 * slant)});
    taken.insert(taken.end(), {from, to});
    --i;
  }
  builder.encounter().goals = {{7.5, 0.0, 0.0}};
}

}  // namespace bslnav
