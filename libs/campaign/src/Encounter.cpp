#include <bslnav/campaign/Encounter.h>
#include <bslnav/config/Config.h>

#include "EncounterBuilder.h"

namespace bslnav {
namespace {

using Build = void (*)(EncounterBuilder&);
constexpr Build kBuild[kFamilies] = {buildOneSided, buildTwoSided, buildCorner,  buildDoors,
                                     buildAisles,   buildBoxes,    buildPillars, buildCrowd};

void mirror(std::vector<mrpt::math::TPoint2D>& points) {
  for (auto& point : points) point.y = -point.y;
}

/** Left becomes right. */
void mirror(Encounter& encounter) {
  for (auto& [name, wall] : encounter.world.walls) mirror(wall.points_m);
  for (auto& [name, box] : encounter.world.boxes)
    box.pose = {box.pose.x, -box.pose.y, -box.pose.phi};
  for (auto& [name, cylinder] : encounter.world.cylinders) cylinder.y_m = -cylinder.y_m;
  for (auto& [name, person] : encounter.world.pedestrians) mirror(person.path_m);
  for (auto& goal : encounter.goals) goal = {goal.x, -goal.y, -goal.phi};
}

}  // namespace

const char* nameOf(Family family) {
  static constexpr const char* kNames[kFamilies] = {"one-sided", "two-sided", "corner",  "doors",
                                                    "aisles",    "boxes",     "pillars", "crowd"};
  return kNames[static_cast<int>(family)];
}

void EncounterParameters::describe(ConfigSection& section) {
  section.number("slowest_mps", slowest_mps, kPositive, "m/s", "lowest speed of people");
  section.number("fastest_mps", fastest_mps, kPositive, "m/s",
                 "highest speed of people; a guard that is to hold needs [guard] person_speed_mps "
                 "of at least this");
  section.number("timing_spread_s", timingSpread_s, kNonNegative, "s",
                 "a person reaches the robot's line at most so long before or after the robot, if "
                 "the robot drives on at a speed between 0.2 and 0.55 m/s");
  section.number("hesitate_share", hesitate_share, {0.0, 1.0}, "",
                 "share of people who stand on their way for 0.5 to 8 s; some of them turn back");
  section.flag("yield", yield, "whether people wait for a robot in their way; else they walk on");
  section.number("patience_s", patience_s, kNonNegative, "s",
                 "who has waited so long walks round the robot, where there is room; 0: waits on");
}

void EncounterParameters::check() const {
  if (fastest_mps < slowest_mps)
    Config::refuse("campaign", "fastest_mps", "a speed of at least slowest_mps");
}

Encounter makeEncounter(const EncounterParameters& parameters, std::uint64_t campaignSeed,
                        long number) {
  Dice dice(campaignSeed, "encounter " + std::to_string(number));
  Encounter encounter;
  encounter.family = static_cast<Family>(number % kFamilies);
  encounter.seed = dice.seed();
  EncounterBuilder builder(parameters, dice, encounter);
  kBuild[static_cast<int>(encounter.family)](builder);
  if (dice.chance(0.5)) mirror(encounter);
  return encounter;
}

}  // namespace bslnav
