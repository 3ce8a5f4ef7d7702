#include <bslnav/campaign/Campaign.h>
#include <bslnav/config/Config.h>
#include <bslnav/evaluation/SimulationRun.h>
#include <bslnav/simulation/RobotBody.h>
#include <bslnav/simulation/WorldShape.h>
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

constexpr int kCyclesAWorld = 6;
constexpr double kAside_m = 0.8;  // so far from the worst place an adversary may stand

/** How many worlds for each kind of sensors; more than a test has time for by
 * BSLNAV_ADVERSARY_WORLDS=400. */
long worlds() {
  const char* asked = std::getenv("BSLNAV_ADVERSARY_WORLDS");
  return asked ? std::atol(asked) : 8;
}

/** The robot of campaigns, with the guard. */
Entrant guarded(const std::string& sensors, const std::string& robot = "") {
  Entrant entrant{5, "dwa", sensors, {}, ""};
  EncounterParameters people;
  Config config;
  config.bind("campaign", "", people);
  entrant.setup.bind(config);
  const std::string directory = dataDirectory() + "/config/";
  std::vector<std::string> files{directory + "campaign.ini", directory + "methods/method5.ini"};
  if (!robot.empty()) files.push_back(directory + robot);
  std::vector<std::string> overrides;
  if (sensors == "laser") overrides.emplace_back("depth.enabled=false");
  config.load(files, overrides);
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

/** Whether somebody can walk there straight, and does not stand on the robot's start. */
bool isClear(const TPoint2D& from, const TPoint2D& to, const PedestrianParameters& person,
             const std::vector<WorldShape>& shapes) {
  RobotBody body({{}, person.radius_m, person.height_m});
  const int steps = 1 + static_cast<int>((to - from).norm() / 0.05);
  for (int k = 0; k <= steps; ++k) {
    const TPoint2D at = from + (to - from) * (1.0 * k / steps);
    body.moveTo({at.x, at.y, 0.0});
    if (body.clearanceTo(shapes) <= 0.0) return false;
    if (k == 0 && body.clearanceTo({0.0, 0.0}, 0.3) <= 0.0) return false;
  }
  return true;
}

/** Somebody who stands as near as there is room to where the binding point is the edge of the body,
 * and walks from that moment on straight to where the robot will be on its way to a standstill, as
 * fast as the guard thinks possible. Nobody, if walls leave no such way. */
std::optional<PedestrianParameters> adversary(const Moment& moment, double ahead, double speed_mps,
                                              const WorldParameters& world) {
  PedestrianParameters person;
  person.speed_mps = speed_mps;
  person.startDelay_s = moment.time_s;
  const TPoint2D edge(moment.binding.x_m, moment.binding.y_m);
  const double braking_m = ahead * moment.speed_mps * (0.2 + moment.speed_mps);
  const TPoint2D target(moment.pose.x + braking_m * std::cos(moment.pose.phi),
                        moment.pose.y + braking_m * std::sin(moment.pose.phi));
  const TPoint2D ideal = edge + (edge - target) * (person.radius_m / (edge - target).norm());
  const auto shapes = worldShapes(world);
  double least = kAside_m;
  for (double dx = -kAside_m; dx <= kAside_m; dx += 0.05)
    for (double dy = -kAside_m; dy <= kAside_m; dy += 0.05) {
      const TPoint2D from = ideal + TPoint2D(dx, dy);
      if (std::hypot(dx, dy) >= least || !isClear(from, target, person, shapes)) continue;
      least = std::hypot(dx, dy);
      person.path_m = {from, target};
    }
  if (person.path_m.empty()) return std::nullopt;
  return person;
}

class Adversary : public testing::TestWithParam<const char*> {};

/** Worlds are those of encounters, without their people. */
TEST_P(Adversary, FromTheWorstFrontierPointMeetsARobotThatStands) {
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
      const auto person = adversary(moment, ahead, fastest_mps, encounter.world);
      if (!person) continue;
      setup.world.pedestrians["adversary"] = *person;
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

/** These two met a robot at 0.06 m/s: standing beside a parked box for a while, each was taken for
 * a part of it. */
TEST(AdversaryRegression, WhoStoodBesideABoxMeetsARobotThatStands) {
  struct Case {
    long encounter;
    double start_s;
    TPoint2D from, to;
  };
  const Case cases[] = {{13, 6.1, {1.40, 0.69}, {1.57, -0.72}},
                        {181, 3.4, {1.49, 1.12}, {1.42, -0.22}}};
  const Entrant entrant = guarded("laser");
  for (const Case& c : cases) {
    Encounter encounter = makeEncounter({}, 99, c.encounter);
    encounter.world.pedestrians.clear();
    SimulationSetup setup = setupOf(entrant, encounter);
    PedestrianParameters person;
    person.speed_mps = entrant.setup.navigation.guard.personSpeed_mps;
    person.startDelay_s = c.start_s;
    person.path_m = {c.from, c.to};
    setup.world.pedestrians["adversary"] = person;
    setup.scenario.timeLimit_s = c.start_s + 4.0;
    EXPECT_FALSE(runSimulation(setup, encounter.seed).atFault) << c.encounter;
  }
}

/** Three people in a crowd walked through each other half a metre from it; they were taken for a
 * wall, and the robot made way for one of them into another at 0.12 m/s. */
TEST(AdversaryRegression, WhoWalkThroughEachOtherMeetARobotThatStands) {
  Entrant entrant = guarded("laser");
  entrant.setup.navigation.movers.approachShare = 1.0;  // as it was then: slower, it meets nobody
  const Encounter encounter = makeEncounter({}, 1, 1647);
  const RunSummary run = runSimulation(setupOf(entrant, encounter), encounter.seed);
  EXPECT_TRUE(run.contact);  // else it is another encounter
  EXPECT_FALSE(run.atFault);
}

/** A holonomic robot on MRPT's engine turned away from somebody who came round a corner, could not
 * come to a standstill before the wall, and touched it at 0.16 m/s. */
TEST(AdversaryRegression, AWallBesideSomebodyIsNotTouched) {
  Entrant entrant = guarded("laser", "robots/holonomic.ini");
  entrant.setup.navigation.navigator.type = NavigatorType::Ptg;
  const Encounter encounter = makeEncounter({}, 1, 2);
  const RunSummary run = runSimulation(setupOf(entrant, encounter), encounter.seed);
  EXPECT_TRUE(run.contact);  // the person walks on
  EXPECT_FALSE(run.atFault);
}

INSTANTIATE_TEST_SUITE_P(Sensors, Adversary, testing::Values("laser", "depth", "both"));

}  // namespace
}  // namespace bslnav
