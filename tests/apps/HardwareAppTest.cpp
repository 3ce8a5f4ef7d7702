#include <EmulatedRobot.h>
#include <bslnav/evaluation/SimulationSetup.h>
#include <bslnav/hardware/CreateParameters.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "AppTest.h"

namespace bslnav::test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

/** The programs on drivers and protocols of real devices, in real time; the devices are emulated in
 * case S1. */
class HardwareApp : public AppTest {
 protected:
  static SimulationCase s1() {
    SimulationSetup setup;
    Config config;
    setup.bind(config);
    config.load({kS1}, {"simulated_robot.max_deceleration_mps2=2",
                        "simulated_robot.max_acceleration_mps2=2"});
    return setup.simulationCase(1);
  }

  Arguments driving(const std::string& name, Arguments more = {}) {
    Arguments arguments{
        kS1,     std::string(BSLNAV_SOURCE_DIR) + "/share/examples/create2/robot.ini",
        "--set", "create.port=" + robot.base().path(),
        "--set", "front_laser.COM_port_LIN=" + robot.laser().path(),
        "--out", path(name)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  bool waitUntil(double seconds, const std::function<bool()>& condition) {
    for (int k = 0; k < static_cast<int>(seconds / 0.01); ++k) {
      if (condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  /** Waits until the robot drives steadily. */
  bool waitUntilItDrives() {
    return waitUntil(20.0, [this] { return robot.state().twist.vx > 0.3; });
  }

  /** How far the robot still drives from now on until it stands. */
  double wayUntilItStands() {
    robot.startMeasuring();
    waitUntil(5.0, [this] { return std::abs(robot.state().twist.vx) < 0.01; });
    return robot.driven_m();
  }

  EmulatedRobot robot{s1(), ScipModel(), CreateParameters().wheelBase_m};
};

class HardwareS1 : public HardwareApp, public testing::WithParamInterface<int> {};

/** The whole way of case S1: the pedestrian walks out when the robot crosses the line. */
TEST_P(HardwareS1, DrivesToTheGoalPastThePedestrian) {
  const AppResult result =
      run(driving("out", {"--method", std::to_string(GetParam()), "--set", "recording.rawlog=true",
                          "--set", "recording.memory_s=1"}));
  ASSERT_EQ(result.exitCode, 0) << result.out << result.err;
  EXPECT_EQ(summary()["outcome"], "goal");
  const SimulationState state = robot.state();
  EXPECT_LT(std::hypot(state.pose.x - 9.5, state.pose.y), 0.4);
  const bool promisesNothing = GetParam() == 2;
  EXPECT_TRUE(promisesNothing || state.contact == SimulationState::Contact::Nothing ||
              state.speedAtContact_mps < 0.05);
  EXPECT_TRUE(state.people.at(0).started);
  EXPECT_TRUE(exists(out("run.rawlog")));
  EXPECT_THAT(readFile(out("memory.csv")), ContainsRegex(",bslnav,[0-9]"));
  EXPECT_THAT(readFile(out("memory.csv")), ContainsRegex(",CHokuyoURG front_laser,[0-9]"));
  EXPECT_TRUE(exists(out("trajectory.png")));
}

INSTANTIATE_TEST_SUITE_P(Methods, HardwareS1, testing::Values(2, 5),
                         [](const auto& test) { return "M" + std::to_string(test.param); });

/** What the program is told from outside, and a distance [m] within which the robot then stands:
 * 0.4 m/s for the watchdog's 0.3 s and a cycle, and what braking needs. */
constexpr double kStandsWithin_m = 0.35;

TEST_F(HardwareApp, StopsTheBaseFirstOnSigterm) {
  AppProcess process("bslnav", driving("out", {"--method", "2"}), path(""));
  ASSERT_TRUE(waitUntilItDrives());
  process.send(SIGTERM);
  EXPECT_LT(wayUntilItStands(), kStandsWithin_m);
  EXPECT_EQ(process.wait().exitCode, 1);
  EXPECT_EQ(summary()["reason"], "interrupted");
}

TEST_F(HardwareApp, StandsWhenTheProgramIsKilled) {
  AppProcess process("bslnav", driving("out", {"--method", "2"}), path(""));
  ASSERT_TRUE(waitUntilItDrives());
  process.send(SIGKILL);
  EXPECT_LT(wayUntilItStands(), kStandsWithin_m);
  process.wait();
  EXPECT_GT(rowsOf(out("cycles.csv")), 5u);
}

/** One fault after the other in one drive, as starting takes most of the time. */
TEST_F(HardwareApp, DrivesOnAfterGarbageAndStandsWhileTheLaserIsFrozenOrGone) {
  AppProcess process("bslnav", driving("out", {"--method", "2"}), path(""));
  ASSERT_TRUE(waitUntilItDrives());
  robot.laser().halveNextPacket();
  robot.base().halveNextFrame();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  robot.laser().sendGarbage(100);
  robot.base().sendGarbage(100);
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  ASSERT_TRUE(waitUntilItDrives());

  robot.laser().freeze(ScipEmulator::Frozen::Ranges);
  EXPECT_LT(wayUntilItStands(), kStandsWithin_m + 0.4 * 1.0);
  robot.laser().freeze(ScipEmulator::Frozen::Not);
  ASSERT_TRUE(waitUntilItDrives());

  robot.laser().pullCable();
  // Half a second is a laser believed to come back; then the robot brakes.
  EXPECT_LT(wayUntilItStands(), kStandsWithin_m + 0.4 * 0.5);
  EXPECT_TRUE(process.isRunning());
  process.send(SIGTERM);
  EXPECT_EQ(process.wait().exitCode, 1);
  EXPECT_THAT(readFile(out("cycles.csv")), HasSubstr("stale"));
}

TEST_F(HardwareApp, StopsTheBaseWhenTheDiskIsFull) {
  AppProcess process("bslnav", driving("out", {"--method", "2"}), path(""));
  ASSERT_TRUE(waitUntilItDrives());
  process.limitFiles(1000);
  EXPECT_LT(wayUntilItStands(), kStandsWithin_m + 0.4 * 3.0);  // until a buffer is to be written
  const AppResult result = process.wait();
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("cycles.csv"));
  EXPECT_GT(rowsOf(out("cycles.csv")), 5u);
}

TEST_F(HardwareApp, ChecksEveryDeviceAndMovesNothing) {
  const AppResult result = run(driving("out", {"--check"}));
  EXPECT_EQ(result.exitCode, 0) << result.out << result.err;
  EXPECT_THAT(result.out, HasSubstr("1081 beams over 270 deg"));
  EXPECT_THAT(result.out, HasSubstr("CHokuyoURG"));
  EXPECT_TRUE(exists(out("check.png")));
  EXPECT_LT(std::abs(robot.state().pose.x), 0.01);

  robot.laser().pullCable();
  const AppResult without = run(driving("without", {"--check"}));
  EXPECT_EQ(without.exitCode, 1);
  EXPECT_THAT(without.out, HasSubstr(robot.laser().path()));
}

TEST_F(HardwareApp, AConfigurationThatMakesNoSenseMovesNothing) {
  const auto refused = [this](const std::string& setting, const std::string& word) {
    const AppResult result = run(driving("out", {"--set", setting}));
    EXPECT_EQ(result.exitCode, 2) << setting;
    EXPECT_THAT(result.err, HasSubstr(word));
  };
  refused("robot.type=banana", "[robot] type");
  refused("create.baud=fast", "[create] baud");
  refused("localization.source=truth", "[localization] source");
  EXPECT_EQ(robot.base().lastDrive().count, 0u);
}

TEST_F(HardwareApp, EndsWhenTheBasesCableIsPulled) {
  AppProcess process("bslnav", driving("out", {"--method", "2"}), path(""));
  ASSERT_TRUE(waitUntilItDrives());
  robot.base().pullCable();  // it drives on, as a real one does: nobody can tell it to stop
  const AppResult result = process.wait();
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(summary()["outcome"], "error");
  EXPECT_THAT(summary()["reason"].get<std::string>(), HasSubstr(robot.base().path()));
}

}  // namespace
}  // namespace bslnav::test
