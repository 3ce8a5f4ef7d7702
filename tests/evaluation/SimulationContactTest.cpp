#include "EvaluationRig.h"

namespace bslnav {
namespace {

using test::hall;

/** Where and how a run ended in contact. */
struct Collision {
  RunSummary summary;
  SimulationState truth;
};

Collision runUntilContact(const SimulationSetup& setup) {
  Collision collision;
  collision.summary = runSimulation(setup, 1, [&](const SimulationMoment& m) {
    collision.truth = m.truth;
    return true;
  });
  return collision;
}

/* The robot (radius 0.25 m) speeds up by 0.05 m/s a period: after 1.1 s it has come
 * 0.005 m · (1 + ... + 11) = 0.33 m and goes on with its top speed, 2/3.6 = 0.5556 m/s. */

TEST(SimulationContact, PersonFromBehindIsMetAtTheTimeOfTheClosedForm) {
  SimulationSetup setup = hall();
  auto& person = setup.world.pedestrians["behind"];  // not seen: the laser looks to ±120°
  person.path_m = {{-4.0, 0.0}, {8.0, 0.0}};
  person.speed_mps = 2.0;
  person.radius_m = 0.25;
  // 2 t − 0.33 − 0.5556 (t − 1.1) = 4 − 0.5, so t = 3.2189 / 1.4444 = 2.228 s.
  const Collision collision = runUntilContact(setup);
  EXPECT_EQ(collision.summary.outcome, Outcome::Contact);
  EXPECT_EQ(collision.summary.reason, "contact with a person");
  EXPECT_EQ(collision.truth.contact, SimulationState::Contact::Person);
  EXPECT_NEAR(collision.truth.contactTime_s, 2.228, 0.015);  // substeps of 10 ms
  EXPECT_NEAR(collision.summary.impactSpeed_mps.value(), 0.5556, 1e-3);
  EXPECT_TRUE(collision.summary.atFault);
  EXPECT_NEAR(collision.summary.duration_s, 2.3, 1e-6);  // the next cycle notices
  // From 2.228 s to 2.3 s they go on through each other with 1.444 m/s.
  EXPECT_NEAR(collision.summary.minClearance_m.value(), -0.072 * 1.444, 0.02);
}

TEST(SimulationContact, BoxBelowTheLaserIsHitAsTheWorld) {
  SimulationSetup setup = hall();
  auto& box = setup.world.boxes["low"];
  box.pose = {2.25, 0.0, 0.0};  // its face at x = 2, the laser 0.2 m above the floor
  box.length_m = box.width_m = 0.5;
  box.zMax_m = 0.1;
  box.mapped = false;
  // 1.75 m to go: 1.1 s + (1.75 − 0.33) / 0.5556 = 3.656 s.
  const Collision collision = runUntilContact(setup);
  EXPECT_EQ(collision.summary.outcome, Outcome::Contact);
  EXPECT_EQ(collision.summary.reason, "contact with the world");
  EXPECT_EQ(collision.truth.contact, SimulationState::Contact::World);
  EXPECT_NEAR(collision.truth.contactTime_s, 3.656, 0.02);
  EXPECT_TRUE(collision.summary.contact);
  EXPECT_TRUE(collision.summary.atFault);
  EXPECT_FALSE(collision.summary.minClearance_m.has_value());
}

TEST(SimulationContact, BoxThatTheLaserSeesIsDrivenAround) {
  SimulationSetup setup = hall();
  auto& box = setup.world.boxes["seen"];
  box.pose = {2.25, 0.0, 0.0};
  box.mapped = false;
  EXPECT_EQ(runSimulation(setup, 1).outcome, Outcome::Goal);
}

TEST(SimulationContact, PersonWhoWalksIntoTheStandingRobotIsNotItsFault) {
  SimulationSetup setup = hall();
  setup.navigation.cycle.sensorMaxAge_s = 1e-3;  // the laser is too slow for that: the robot stands
  setup.lasers["front"].latency_s = 0.05;
  auto& person = setup.world.pedestrians["walker"];
  person.path_m = {{-2.0, 0.0}, {4.0, 0.0}};
  person.speed_mps = 1.0;
  person.radius_m = 0.25;
  const Collision collision = runUntilContact(setup);
  EXPECT_EQ(collision.summary.outcome, Outcome::Contact);
  EXPECT_FALSE(collision.summary.atFault);
  EXPECT_EQ(collision.summary.impactSpeed_mps.value(), 0.0);
  EXPECT_NEAR(collision.truth.contactTime_s, 1.5, 0.015);  // 2 m less two radii at 1 m/s
  EXPECT_EQ(collision.summary.unhealthyCycles, collision.summary.cycles);
}

}  // namespace
}  // namespace bslnav
