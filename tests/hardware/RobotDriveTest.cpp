#include <ScipEmulator.h>
#include <bslnav/hardware/RobotDrive.h>
#include <gmock/gmock.h>
#include <mrpt/core/Clock.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "RecordingBase.h"

namespace bslnav::test {
namespace {

using testing::HasSubstr;
using Kind = DriveEnd::Kind;

constexpr double kDrives_mps = 0.15;  // less than on a machine that is always on time

/** A robot that stays where it is whatever it is told, in the middle of a round place; its laser's
 * ranges have noise. */
class RobotDriveTest : public testing::Test {
 protected:
  RobotDriveTest() {
    parameters.guard.enabled = false;
    drive.timeLimit_s = 40.0;
    shine();
  }

  void shine() {
    std::vector<float> ranges(static_cast<std::size_t>(laser.model().beams()));
    for (float& range : ranges) range = 3.0f + 0.001f * static_cast<float>(dice() % 10);
    laser.setRanges(std::move(ranges));
  }

  std::map<std::string, Config::FreeSection> drivers() const {
    return {{"front",
             {{"driver", "CHokuyoURG"},
              {"process_rate", "500"},
              {"COM_port_LIN", laser.path()},
              {"disable_firmware_timestamp", "true"}}}};
  }

  /** Drives until the observer returns false. */
  DriveEnd run(const RobotDrive::Observer& observer) {
    NavigationCycle cycle(parameters, nullptr);
    cycle.setGoals({{2.2, 0.0, 0.0}});
    cycle.expectSensor(SensorKind::Laser, "front");
    Sensors sensors(drivers(), {}, BSLNAV_SENSOR_PROGRAM, "");
    OdometryLocalization localization({});
    RobotDrive robot(cycle, base, sensors, &localization, drive, 0.1);
    return robot.run([&](const DriveMoment& moment) {
      shine();
      return observer(moment);
    });
  }

  std::mt19937 dice{1};
  ScipEmulator laser{ScipModel::urg04lx()};
  NavigationParameters parameters;
  DriveParameters drive;
  RecordingBase base;
};

/** Nothing moves before the laser has been heard; then the robot drives; whatever ends the drive
 * stops the base. */
TEST_F(RobotDriveTest, WaitsForItsSensorsThenDrivesAndStopsInTheEnd) {
  bool waited = false;
  const DriveEnd end = run([&](const DriveMoment& moment) {
    if (moment.record.health == CycleRecord::Health::StaleSensor) {
      waited = true;
      EXPECT_EQ(base.command().vx, 0.0);
    }
    return base.command().vx < kDrives_mps;
  });
  EXPECT_EQ(end.kind, Kind::Interrupted);
  EXPECT_TRUE(waited);
  EXPECT_EQ(base.command().vx, 0.0);
  EXPECT_GE(base.stops(), 1);
}

TEST_F(RobotDriveTest, AStalledLoopIsStoppedByTheWatchdogAndGoesOnSlowly) {
  bool stalled = false, told = false;
  double speedInTheStall_mps = 1.0;
  run([&](const DriveMoment& moment) {
    if (!stalled && base.command().vx > kDrives_mps) {
      stalled = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
      speedInTheStall_mps = base.command().vx;
      return true;
    }
    if (stalled && !told) {
      told = moment.problem.find("the control loop") != std::string::npos;
      EXPECT_TRUE(told) << moment.problem;
      EXPECT_LT(base.command().vx, 0.1);  // anew, from standstill
      EXPECT_LT(moment.pace.share(), 0.75);
      EXPECT_GE(moment.pace.misses(), 1);
    }
    return !told;
  });
  EXPECT_TRUE(told);
  EXPECT_EQ(speedInTheStall_mps, 0.0);
}

/** A base whose odometry is no number from some time on. */
class Confused : public RecordingBase {
 public:
  BaseState state() override {
    BaseState state = RecordingBase::state();
    if (isConfused) state.odometry.x = std::numeric_limits<double>::quiet_NaN();
    return state;
  }
  bool isConfused = false;
};

TEST_F(RobotDriveTest, APoseThatIsNoNumberStopsTheRobotUntilItIsOneAgain) {
  Confused confused;
  NavigationCycle cycle(parameters, nullptr);
  cycle.setGoals({{2.2, 0.0, 0.0}});
  Sensors sensors(drivers(), {}, BSLNAV_SENSOR_PROGRAM, "");
  OdometryLocalization localization({});
  drive.watchdog = {5.0, 5.0, 5.0};  // it would have its say, too
  RobotDrive robot(cycle, confused, sensors, &localization, drive, 0.1);
  int stage = 0, cycles = 0;
  robot.run([&](const DriveMoment& moment) {
    shine();
    ++cycles;
    const double speed = confused.command().vx;
    if (stage == 0 && speed > kDrives_mps) {
      confused.isConfused = true;
      stage = 1;
      cycles = 0;
    } else if (stage == 1 && cycles > 1) {
      EXPECT_EQ(moment.record.health, CycleRecord::Health::BadPose);
      EXPECT_THAT(moment.problem, HasSubstr("odometry is no number"));
      if (speed == 0.0) {
        confused.isConfused = false;
        stage = 2;
      }
    } else if (stage == 2 && speed > kDrives_mps) {
      stage = 3;
    }
    return stage < 3;
  });
  EXPECT_EQ(stage, 3);
}

/** A base on a machine whose clock jumps. */
class Jumping : public RecordingBase {
 public:
  BaseState state() override {
    BaseState state = RecordingBase::state();
    state.stamp_s += jump_s;
    return state;
  }
  DriveClock clock() const {
    const auto steady = [] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
          .count();
    };
    return {steady, [this] { return mrpt::Clock::nowDouble() + jump_s; }};
  }
  double jump_s = 0.0;
};

/** An hour ahead, as when the time is set by radio: scans still have the old time, so the robot
 * stands; then back again, and it drives on. The drive's own time notices nothing. */
TEST_F(RobotDriveTest, AClockThatJumpsStopsTheRobotUntilItsSensorsFollow) {
  Jumping jumping;
  NavigationCycle cycle(parameters, nullptr);
  cycle.setGoals({{2.2, 0.0, 0.0}});
  cycle.expectSensor(SensorKind::Laser, "front");
  Sensors sensors(drivers(), {}, BSLNAV_SENSOR_PROGRAM, "");
  OdometryLocalization localization({});
  RobotDrive robot(cycle, jumping, sensors, &localization, drive, 0.1, jumping.clock());
  int stage = 0, jumps = 0;
  double time_s = 0.0, longest_s = 0.0;
  robot.run([&](const DriveMoment& moment) {
    shine();
    longest_s = std::max(longest_s, moment.record.time_s - time_s);
    time_s = moment.record.time_s;
    EXPECT_EQ(moment.frame.afterGap, moment.problem == "the clock jumped");
    jumps += moment.frame.afterGap;
    const double speed = jumping.command().vx;
    if (stage == 0 && speed > kDrives_mps) {
      jumping.jump_s = 3600.0;
      stage = 1;
    } else if (stage == 1 && speed == 0.0) {
      EXPECT_EQ(moment.record.health, CycleRecord::Health::StaleSensor);
      EXPECT_THAT(sensors.reports().at(0).lastRefusal, HasSubstr("before the last one"));
      jumping.jump_s = 0.0;
      stage = 2;
    } else if (stage == 2 && speed > kDrives_mps) {
      stage = 3;
    }
    return stage < 3;
  });
  EXPECT_EQ(stage, 3);
  EXPECT_EQ(jumps, 2);
  EXPECT_LT(longest_s, 1.0);
}

/** What records, may fail: the disk is full. */
TEST_F(RobotDriveTest, AnExceptionOfTheObserverStopsTheBase) {
  const DriveEnd end = run([&](const DriveMoment&) -> bool {
    if (base.command().vx > kDrives_mps) throw std::runtime_error("the disk is full");
    return true;
  });
  EXPECT_EQ(end.kind, Kind::Failed);
  EXPECT_THAT(end.reason, HasSubstr("the disk is full"));
  EXPECT_EQ(base.command().vx, 0.0);
}

}  // namespace
}  // namespace bslnav::test
