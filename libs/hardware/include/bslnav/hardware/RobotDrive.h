#pragma once

#include <bslnav/hardware/Base.h>
#include <bslnav/hardware/DriveClock.h>
#include <bslnav/hardware/PaceKeeper.h>
#include <bslnav/hardware/Sensors.h>
#include <bslnav/hardware/Watchdog.h>
#include <bslnav/navigation/Localization.h>
#include <bslnav/navigation/NavigationCycle.h>

#include <functional>
#include <string>

namespace bslnav {

struct DriveParameters {
  Watchdog::Limits watchdog;
  double poseMaxAge_s = 0.3;  ///< an older state of the base is none: the robot stops
  double lostAbove_m = 0.5;   ///< with a pose less certain than this the robot stops
  double timeLimit_s = 0.0;   ///< the drive ends after this; 0: never

  void describe(ConfigSection& section);
};

/** What an observer of a drive sees after every control cycle. */
struct DriveMoment {
  const CycleRecord& record;  ///< its command is the one that was sent
  const SensorFrame& frame;
  const PaceKeeper& pace;
  std::string problem;  ///< what stopped the robot besides the record's reason; empty: nothing
};

struct DriveEnd {
  enum class Kind { Arrived, GaveUp, TimeLimit, Interrupted, Failed } kind;
  std::string reason;
};

/** Drives a real robot, in real time: senses, runs a control cycle, sends its command; and whatever
 * happens, tells the base to stop. */
class RobotDrive {
 public:
  /** Called after every cycle, when the command is sent; returning false interrupts the drive. */
  using Observer = std::function<bool(const DriveMoment&)>;

  /** @param localization null: the base localises itself. All but the clock outlive this object. */
  RobotDrive(NavigationCycle& cycle, Base& base, Sensors& sensors, Localization* localization,
             const DriveParameters& parameters, double period_s, DriveClock clock = DriveClock());

  /** Until the goal is reached, or something else ends it; never throws. */
  DriveEnd run(const Observer& observer);

 private:
  void sense();
  mrpt::math::TPose2D locate(const BaseState& state);
  DriveEnd loop(const Observer& observer);

  NavigationCycle& cycle_;
  Base& base_;
  Sensors& sensors_;
  Localization* localization_;
  DriveParameters parameters_;
  double period_s_;
  DriveClock clock_;
  SensorFrame frame_;
  std::string problem_;
};

}  // namespace bslnav
