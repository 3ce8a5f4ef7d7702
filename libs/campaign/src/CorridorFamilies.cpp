// Corridors with openings, doors and corners.
#include <algorithm>

#include "EncounterBuilder.h"

namespace bslnav {
namespace {

constexpr double kGoal_m = 7.5;
constexpr double kFromWall_m = 0.4;  // where people stand, from the middle of a wall

/** Out of an opening in the right wall, across to the left wall: where the person ends. */
void personOutOf(EncounterBuilder& builder, const Opening& opening, double right_m, double end_m) {
  Dice& dice = builder.dice();
  const double aside = std::max(0.0, 0.5 * opening.width_m - kFromWall_m);
  const double x = opening.x_m + dice.between(-aside, aside);
  const double from = -right_m - opening.depth_m + kFromWall_m +
                      dice.between(0.0, 0.4) * (opening.depth_m - 2.0 * kFromWall_m);
  const double toX = opening.x_m + dice.between(-aside, aside);
  builder.person({{x, from}, {toX, end_m}}, {opening.x_m, -from});
}

}  // namespace

void buildOneSided(EncounterBuilder& builder) {
  Dice& dice = builder.dice();
  CorridorPlan plan;
  plan.right_m = dice.between(0.8, 1.2);
  plan.left_m = dice.between(1.1, 2.0);
  plan.rightOpenings = {{dice.between(3.5, 5.0), dice.between(1.0, 2.0), dice.between(1.8, 2.6)}};
  plan.length_m = 9.0;
  builder.corridor(plan);
  personOutOf(builder, plan.rightOpenings.front(), plan.right_m, plan.left_m - kFromWall_m);
  builder.encounter().goals = {{kGoal_m, 0.0, 0.0}};
  const Opening& opening = plan.rightOpenings.front();
  constexpr double kHalfWall_m = 0.05;  // walls are drawn by their middles
  CornerPass pass;
  pass.right_m = plan.right_m - kHalfWall_m;
  pass.left_m = plan.left_m - kHalfWall_m;
  pass.openingFrom_m = opening.x_m - 0.5 * opening.width_m + kHalfWall_m;
  pass.openingTo_m = opening.x_m + 0.5 * opening.width_m - kHalfWall_m;
  pass.depth_m = opening.depth_m;
  pass.goal_m = kGoal_m;
  builder.encounter().pass = pass;
}

void buildTwoSided(EncounterBuilder& builder) {
  Dice& dice = builder.dice();
  CorridorPlan plan;
  plan.right_m = dice.between(0.8, 1.3);
  plan.left_m = dice.between(0.9, 1.5);
  const double x = dice.between(3.5, 5.0), width = dice.between(1.0, 2.0);
  plan.rightOpenings = {{x, width, dice.between(1.8, 2.6)}};
  plan.leftOpenings = {{x, width, dice.between(1.8, 2.6)}};
  plan.length_m = 9.0;
  builder.corridor(plan);
  // Walks right through, into the niche on the other side.
  const Opening& left = plan.leftOpenings.front();
  personOutOf(builder, plan.rightOpenings.front(), plan.right_m,
              plan.left_m + left.depth_m - kFromWall_m);
  builder.encounter().goals = {{kGoal_m, 0.0, 0.0}};
}

void buildCorner(EncounterBuilder& builder) {
  Dice& dice = builder.dice();
  const double right = dice.between(0.9, 1.3), left = dice.between(0.9, 1.3);
  const double x = dice.between(3.5, 4.5), y = dice.between(3.5, 4.5);
  const double near = dice.between(0.9, 1.3), far = dice.between(0.9, 1.3);
  const double end = y + 1.5;
  builder.wall({{-1.5, -right},
                {x + far, -right},
                {x + far, end},
                {x - near, end},
                {x - near, left},
                {-1.5, left},
                {-1.5, -right}});
  builder.encounter().goals = {{x, y, 0.5 * M_PI}};
  // Comes down the other leg, round the corner, and past the robot's start to the end.
  const double lane = dice.between(-near + 0.5, far - 0.5);
  const double turn = dice.between(-right + 0.5, left - 0.5);
  const mrpt::math::TPoint2D corner(x + lane, turn);
  const double from = std::min(end - 0.5, turn + dice.between(2.0, 4.5));
  builder.person({{corner.x, from}, corner, {-1.0, (dice.side() > 0 ? left - 0.4 : -right + 0.4)}},
                 {x, from - turn});
}

void buildDoors(EncounterBuilder& builder) {
  Dice& dice = builder.dice();
  CorridorPlan plan;
  plan.right_m = dice.between(0.9, 1.3);
  plan.left_m = dice.between(0.9, 1.3);
  plan.length_m = 9.0;
  for (int i = 0; i < 3; ++i) {
    const double x = 2.2 + 2.0 * i;
    plan.rightOpenings.push_back({x + dice.between(-0.3, 0.3), 0.9, 1.6});
    plan.leftOpenings.push_back({x + dice.between(-0.3, 0.3), 0.9, 1.6});
  }
  builder.corridor(plan);
  const int first = dice.whole(0, 2);
  personOutOf(builder, plan.rightOpenings[static_cast<std::size_t>(first)], plan.right_m,
              plan.left_m - kFromWall_m);
  if (dice.chance(0.5))
    personOutOf(builder, plan.rightOpenings[static_cast<std::size_t>((first + 1) % 3)],
                plan.right_m, plan.left_m - kFromWall_m);
  builder.encounter().goals = {{kGoal_m, 0.0, 0.0}};
}

}  // namespace bslnav
