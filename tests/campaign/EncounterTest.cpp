#include <bslnav/blindspot/HiddenPeople.h>
#include <bslnav/campaign/Encounter.h>
#include <bslnav/simulation/RobotBody.h>
#include <bslnav/simulation/WorldShape.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <set>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

constexpr long kEncounters = 400;

/** Least distance from a disc that moves along a path to the solids. */
double clearanceAlong(const std::vector<TPoint2D>& path, double radius_m,
                      const std::vector<WorldShape>& shapes) {
  RobotBody body({{}, radius_m, 1.7});
  double least = 1e9;
  for (std::size_t i = 1; i < path.size(); ++i)
    for (int step = 0; step <= 100; ++step) {
      const TPoint2D at = path[i - 1] + (path[i] - path[i - 1]) * (step / 100.0);
      body.moveTo({at.x, at.y, 0.0});
      least = std::min(least, body.clearanceTo(shapes));
    }
  return least;
}

TEST(Encounter, IsTheSameForTheSameSeedAndNumberAndNoOther) {
  const EncounterParameters parameters;
  const Encounter a = makeEncounter(parameters, 7, 12), b = makeEncounter(parameters, 7, 12);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.family, b.family);
  ASSERT_EQ(a.world.pedestrians.size(), b.world.pedestrians.size());
  EXPECT_EQ(a.world.pedestrians.at("person_1").path_m, b.world.pedestrians.at("person_1").path_m);
  EXPECT_EQ(a.world.pedestrians.at("person_1").speed_mps,
            b.world.pedestrians.at("person_1").speed_mps);
  EXPECT_NE(a.seed, makeEncounter(parameters, 8, 12).seed);
  EXPECT_NE(a.seed, makeEncounter(parameters, 7, 12 + kFamilies).seed);
}

TEST(Encounter, FamiliesTakeTurns) {
  std::set<std::string> names;
  for (long number = 0; number < kFamilies; ++number)
    names.insert(nameOf(makeEncounter({}, 1, number).family));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kFamilies));
}

TEST(Encounter, PeopleWalkThroughFreePlacesAtTheSpeedsThatWereAskedFor) {
  EncounterParameters parameters;
  parameters.slowest_mps = 0.8;
  parameters.fastest_mps = 1.6;
  for (long number = 0; number < kEncounters; ++number) {
    const Encounter encounter = makeEncounter(parameters, 3, number);
    encounter.world.check();
    const auto shapes = worldShapes(encounter.world);
    ASSERT_FALSE(encounter.world.pedestrians.empty());
    for (const auto& [name, person] : encounter.world.pedestrians) {
      EXPECT_GE(person.speed_mps, 0.8);
      EXPECT_LE(person.speed_mps, 1.6);
      EXPECT_GT(clearanceAlong(person.path_m, person.radius_m, shapes), 0.0)
          << nameOf(encounter.family) << " " << number << " " << name;
    }
  }
}

/** Two who stood in each other would look like a wall. */
TEST(Encounter, InACrowdPeopleStandBesideEachOther) {
  for (long number = kFamilies - 1; number < kEncounters; number += kFamilies) {
    const Encounter encounter = makeEncounter({}, 3, number);
    ASSERT_EQ(encounter.family, Family::Crowd);
    std::vector<mrpt::math::TPoint2D> places;
    for (const auto& [name, person] : encounter.world.pedestrians) {
      for (const auto& other : places)
        for (const auto& place : {person.path_m.front(), person.path_m.back()})
          EXPECT_GE((place - other).norm(), 0.6) << number;
      places.insert(places.end(), {person.path_m.front(), person.path_m.back()});
    }
  }
}

TEST(Encounter, TheRobotStartsFreeOfPeopleAndItsGoalIsFree) {
  for (long number = 0; number < kEncounters; ++number) {
    const Encounter encounter = makeEncounter({}, 3, number);
    RobotBody body({{}, 0.25, 1.0});
    for (const auto& pose : {encounter.start, encounter.goals.back()}) {
      body.moveTo(pose);
      EXPECT_GT(body.clearanceTo(worldShapes(encounter.world)), 0.1)
          << nameOf(encounter.family) << " " << number;
    }
    body.moveTo(encounter.start);
    for (const auto& [name, person] : encounter.world.pedestrians)
      EXPECT_GT(body.clearanceTo(person.path_m.front(), person.radius_m), 0.3)
          << nameOf(encounter.family) << " " << number << " " << name;
  }
}

/** The yardstick's people are as wide as the guard's, and to fear them takes time. */
TEST(Encounter, TheYardstickOfAnOpeningFearsPeople) {
  const StoppingAbility robot{0.25, 0.5, 0.2};
  for (long number = 0; number < 10 * kFamilies; ++number) {
    const Encounter encounter = makeEncounter({}, 1, number);
    ASSERT_EQ(encounter.pass.has_value(), encounter.family == Family::OneSided);
    if (!encounter.pass) continue;
    const CornerPass& pass = *encounter.pass;
    EXPECT_EQ(pass.personRadius_m, HiddenPeopleParameters().radius_m);
    EXPECT_EQ(pass.goal_m, encounter.goals.back().x);
    EXPECT_GT(*fastestPass_s(pass, robot, 0.5, 0.56, 1.6),
              *fastestPass_s(pass, robot, 0.5, 0.56, 0.0) + 0.05)
        << number;
  }
}

TEST(Encounter, HalfOfThePlacesAreMirrored) {
  long left = 0;
  for (long number = 0; number < kEncounters; number += kFamilies)  // one-sided ones
    left += makeEncounter({}, 5, number).world.pedestrians.at("person_1").path_m.front().y > 0.0;
  EXPECT_GT(left, 10);
  EXPECT_LT(left, 40);
}

TEST(Encounter, SomePeopleHesitateAndAllYieldWhenAsked) {
  EncounterParameters parameters;
  parameters.yield = true;
  long pauses = 0, people = 0, turnBack = 0;
  for (long number = 0; number < kEncounters; ++number)
    for (const auto& [name, person] : makeEncounter(parameters, 1, number).world.pedestrians) {
      ++people;
      pauses += person.pause_s > 0.0;
      turnBack += person.path_m.front() == person.path_m.back();
      EXPECT_GT(person.yieldsWithin_m, 0.5);
      EXPECT_GT(person.walksRoundAfter_s, 0.0);
    }
  EXPECT_NEAR(static_cast<double>(pauses) / static_cast<double>(people), 0.35, 0.06);
  EXPECT_GT(turnBack, 10);
}

}  // namespace
}  // namespace bslnav
