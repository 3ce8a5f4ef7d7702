#include "NavigationCycleRig.h"

namespace bslnav {
namespace {

using test::CycleRig;
using test::kPeriod_s;
using test::makeScan;
using test::method;
using Health = CycleRecord::Health;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/** A robot that has driven towards a goal for 1.5 s: full speed, 0.556 m/s. */
class NavigationCycleHealth : public testing::Test {
 protected:
  NavigationCycleHealth() {
    rig.cycle.setGoals({{9.0, 0.0, 0.0}});
    rig.drive(15);
    EXPECT_GT(rig.twist.vx, 0.5);
  }
  /** Sends frames changed by `spoil` until the robot should stand: 0.556 m/s : 0.05 m/s a cycle. */
  void expectStop(Health health, const std::function<void(SensorFrame&)>& spoil) {
    for (int i = 0; i < 12; ++i) {
      SensorFrame frame = rig.frame();
      spoil(frame);
      const double before = rig.twist.vx;
      const CycleRecord& record = rig.step(frame);
      ASSERT_EQ(record.health, health) << nameOf(record.health);
      ASSERT_NEAR(record.motion.command.vx, std::max(0.0, before - 0.05), 1e-9);
      ASSERT_FALSE(reasonOf(record).empty());
    }
    EXPECT_EQ(rig.twist.vx, 0.0);
    rig.drive(3);
    EXPECT_GT(rig.twist.vx, 0.0) << "it should go on with good frames";
  }

  CycleRig rig;
};

TEST_F(NavigationCycleHealth, StaleSensorStopsWithinTheLimits) {
  const auto old = makeScan(rig.time_s - 0.6, [](int) { return 0.0; });
  rig.time_s += 0.5;  // no frames for half a second
  expectStop(Health::StaleSensor, [&](SensorFrame& frame) { frame.scans = {old}; });
}

TEST_F(NavigationCycleHealth, NoScanAtAllIsStaleFromTheBeginning) {
  CycleRig fresh;
  fresh.cycle.setGoals({{3.0, 0.0, 0.0}});
  SensorFrame frame = fresh.frame();
  frame.scans.clear();
  EXPECT_EQ(fresh.step(frame).health, Health::StaleSensor);
  EXPECT_EQ(fresh.twist.vx, 0.0);
}

TEST_F(NavigationCycleHealth, NaNPoseStops) {
  expectStop(Health::BadPose, [](SensorFrame& frame) { frame.mapFromRobot.y = kNaN; });
}

TEST_F(NavigationCycleHealth, NaNTwistStopsFromTheSpeedLastCommanded) {
  expectStop(Health::BadPose, [](SensorFrame& frame) { frame.twist.vx = kNaN; });
}

TEST_F(NavigationCycleHealth, NaNTwistInTheFirstCycleGivesAStandstill) {
  CycleRig fresh;
  fresh.cycle.setGoals({{3.0, 0.0, 0.0}});
  SensorFrame frame = fresh.frame();
  frame.twist = {kNaN, kNaN, kNaN};
  const auto command = fresh.cycle.step(frame).motion.command;
  EXPECT_EQ(command, mrpt::math::TTwist2D());
}

TEST_F(NavigationCycleHealth, ScanOfNothingButNaNStops) {
  expectStop(Health::NoBeams, [this](SensorFrame& frame) {
    frame.scans = {makeScan(rig.time_s, [](int) { return kNaN; })};
  });
}

TEST_F(NavigationCycleHealth, ScanWithoutBeamsStops) {
  auto empty = std::make_shared<mrpt::obs::CObservation2DRangeScan>();
  expectStop(Health::NoBeams, [&](SensorFrame& frame) {
    empty->timestamp = frame.scans[0]->timestamp;
    frame.scans = {empty};
  });
}

TEST_F(NavigationCycleHealth, OneBlindLaserOfTwoStops) {
  expectStop(Health::NoBeams, [this](SensorFrame& frame) {
    frame.scans.push_back(makeScan(rig.time_s, [](int) { return kNaN; }));
  });
}

TEST_F(NavigationCycleHealth, UnusableScanDoesNotCountAsNews) {
  SensorFrame frame = rig.frame();
  for (int i = 0; i < 10; ++i) {  // a second of NaN, then nothing
    frame = rig.frame();
    frame.scans = {makeScan(rig.time_s, [](int) { return kNaN; })};
    rig.step(frame);
  }
  frame = rig.frame();
  frame.scans.clear();
  EXPECT_EQ(rig.step(frame).health, Health::StaleSensor);
}

TEST_F(NavigationCycleHealth, StampAheadOfTheClockDoesNotKeepOldScansFresh) {
  SensorFrame frame = rig.frame();
  frame.scans = {makeScan(rig.time_s + 1000.0, [](int) { return 0.0; })};
  rig.step(frame);
  for (int i = 0; i < 7; ++i) {  // stale after 0.5 s
    frame = rig.frame();
    frame.scans.clear();
    rig.step(frame);
  }
  EXPECT_EQ(rig.cycle.step(frame).health, Health::StaleSensor);
}

TEST_F(NavigationCycleHealth, GoesOnBetweenTheScansOfASlowLaserUntilTheyAreStale) {
  for (int i = 0; i < 20; ++i) {  // a scan every 0.4 s
    SensorFrame frame = rig.frame();
    if (i % 4 != 0) frame.scans.clear();
    ASSERT_EQ(rig.step(frame).health, Health::Ok);
    ASSERT_GT(rig.twist.vx, 0.5);
  }
  // The newest scan is 0.4 s old in the next cycle, and 0.5 s, which is just not stale, after that.
  const Health expected[] = {Health::Ok, Health::Ok, Health::StaleSensor};
  for (const Health health : expected) {
    SensorFrame frame = rig.frame();
    frame.scans.clear();
    frame.time_s -= 1e-3;  // away from the border
    EXPECT_EQ(rig.step(frame).health, health);
  }
}

TEST_F(NavigationCycleHealth, CountsBeamsAndDroppedBeams) {
  SensorFrame frame = rig.frame();
  frame.scans = {
      makeScan(rig.time_s, [](int bearing_deg) { return bearing_deg < 0 ? kNaN : 4.0; })};
  const CycleRecord& record = rig.step(frame);
  EXPECT_EQ(record.health, Health::Ok);
  EXPECT_EQ(record.beams, 181);
  EXPECT_EQ(record.droppedBeams, 90);
}

TEST(NavigationCycleRange, RangesFromTheConfiguredMaximumOnAreNoObstacles) {
  NavigationParameters parameters = method(1);
  parameters.cycle.sensorMaxRange_m = 3.0;
  CycleRig limitedRange(parameters), unlimited;
  for (CycleRig* rig : {&limitedRange, &unlimited}) {
    rig->range_m = [](int) { return 3.5; };
    rig->step();
  }
  EXPECT_EQ(unlimited.cycle.surroundings().localCosts().costAt(3.51, 0.0), kLethalCost);
  EXPECT_EQ(limitedRange.cycle.surroundings().localCosts().costAt(3.51, 0.0), kFreeCost);
}

}  // namespace
}  // namespace bslnav
