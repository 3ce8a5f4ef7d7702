#include <bslnav/config/Error.h>
#include <bslnav/simulation/Simulator.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "MvsimRig.h"

namespace bslnav {
namespace {

using mrpt::obs::CObservation2DRangeScan;
using test::room;
using testing::HasSubstr;

/** Differences [m] of the beams that both scans have, sorted; a beam that one scan alone has counts
 * as 1 m. */
std::vector<double> differences(const CObservation2DRangeScan& a,
                                const CObservation2DRangeScan& b) {
  std::vector<double> result;
  for (std::size_t i = 0; i < a.getScanSize(); ++i) {
    const bool inA = a.getScanRangeValidity(i), inB = b.getScanRangeValidity(i);
    if (inA && inB)
      result.push_back(std::abs(double{a.getScanRange(i)} - double{b.getScanRange(i)}));
    else if (inA != inB)
      result.push_back(1.0);
  }
  std::sort(result.begin(), result.end());
  return result;
}

/* Straight walls differ by float rounding, round bodies by 1.3 % of their radius. Where a beam
 * grazes an edge, one of the two may miss: up to 1 of 100 beams. */
void expectSameScan(SimulationEngine& a, SimulationEngine& b) {
  const auto scansA = a.senseScans(), scansB = b.senseScans();
  ASSERT_EQ(scansA.size(), 1u);
  ASSERT_EQ(scansB.size(), 1u);
  EXPECT_EQ(scansA[0]->sensorLabel, scansB[0]->sensorLabel);
  EXPECT_EQ(scansA[0]->timestamp, scansB[0]->timestamp);
  EXPECT_EQ(scansA[0]->sensorPose, scansB[0]->sensorPose);
  ASSERT_EQ(scansA[0]->getScanSize(), scansB[0]->getScanSize());
  const auto sorted = differences(*scansA[0], *scansB[0]);
  ASSERT_GT(sorted.size(), 600u);
  EXPECT_LT(sorted[sorted.size() / 2], 1e-4);
  EXPECT_LT(sorted[sorted.size() * 99 / 100], 0.01);
}

TEST(MvsimSimulator, ScansEqualOursWithinACentimetre) {
  MvsimSimulator mvsim(room());
  Simulator ours(room());
  expectSameScan(mvsim, ours);
  for (int k = 0; k < 15; ++k) {  // standing, while the person walks 1.5 m
    mvsim.step({}, 0.1);
    ours.step({}, 0.1);
    ASSERT_NEAR(mvsim.state().people[0].position.y, 1.0 - 0.1 * (k + 1), 1e-9);
    expectSameScan(mvsim, ours);
  }
}

TEST(MvsimSimulator, ScanIsOfTheTimeOnItsStamp) {
  SimulationCase simulated = room();
  simulated.lasers["front"].latency_s = 0.05;
  MvsimSimulator mvsim(simulated);
  EXPECT_TRUE(mvsim.senseScans().empty());  // that of time 0 is on its way
  mvsim.step({}, 0.12);
  const auto scans = mvsim.senseScans();
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_NEAR(mrpt::Clock::toDouble(scans[0]->timestamp), SimulationEngine::kEpoch_s, 1e-6);
  mvsim.step({}, 0.03);
  EXPECT_NEAR(mrpt::Clock::toDouble(mvsim.senseScans().at(0)->timestamp),
              SimulationEngine::kEpoch_s + 0.1, 1e-6);
}

/* 2 s on a circle of 0.5 m/s and 0.5 rad/s (radius 1 m), by 1 rad; MVSim is one substep late. */
TEST(MvsimSimulator, DrivesArcsAndItsWheelsTellOfThem) {
  SimulationCase simulated = room();
  simulated.world = {};
  simulated.start = {0.0, 0.0, 0.0};
  MvsimSimulator mvsim(simulated);
  for (int k = 0; k < 20; ++k) mvsim.step({0.5, 0.0, 0.5}, 0.1);
  for (const auto& pose : {mvsim.state().pose, mvsim.state().odometry}) {
    EXPECT_NEAR(pose.x, std::sin(1.0), 0.02);
    EXPECT_NEAR(pose.y, 1.0 - std::cos(1.0), 0.02);
    EXPECT_NEAR(pose.phi, 1.0, 0.02);
  }
  EXPECT_NEAR(mvsim.state().twist.vx, 0.5, 1e-3);
  EXPECT_NEAR(mvsim.state().twist.omega, 0.5, 1e-3);
  EXPECT_NEAR(mvsim.state().time_s, 2.0, 1e-9);
}

TEST(MvsimSimulator, ContactIsJudgedAsInOurSimulator) {
  SimulationCase simulated = room();
  simulated.world.pedestrians.clear();
  simulated.start = {0.0, 0.0, M_PI};
  MvsimSimulator mvsim(simulated);
  for (int k = 0; k < 30; ++k) mvsim.step({0.8, 0.0, 0.0}, 0.1);
  // The wall's face at x = -1.95 m, radius 0.25 m: 1.7 m at 0.8 m/s is 2.125 s.
  EXPECT_EQ(mvsim.state().contact, SimulationState::Contact::World);
  EXPECT_NEAR(mvsim.state().contactTime_s, 2.125, 0.04);
}

std::string refusalOf(const SimulationCase& simulated) {
  try {
    MvsimSimulator mvsim(simulated);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(MvsimSimulator, RefusesWhatItCannotSimulate) {
  SimulationCase simulated = room();
  simulated.cameras["eye"] = DepthCameraParameters{};
  EXPECT_THAT(refusalOf(simulated), HasSubstr("[simulation] engine"));
  simulated = room();
  simulated.robot.kinematics = BaseKinematics::Holonomic;
  EXPECT_THAT(refusalOf(simulated), HasSubstr("[simulated_robot] kinematics"));
  simulated = room();
  simulated.start = {1.0, 1.5, 0.0};
  EXPECT_THAT(refusalOf(simulated), HasSubstr("cylinder:pole"));
}

}  // namespace
}  // namespace bslnav
