#pragma once

#include <bslnav/navigation/MotionGuard.h>
#include <bslnav/navigation/Route.h>
#include <bslnav/planning/ApproachSpeed.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bslnav {

/** One control cycle: what the robot senses → blind spots → costs → path → command, with a record
 * of all of it.
 *
 * The same object serves simulator, hardware and rawlogs and does not know which. Given the same
 * frames, parameters and goals it returns the same bits (but for the stage times). Nothing in the
 * steady cycle allocates, except for a new path. */
class NavigationCycle {
 public:
  /** @param map static map, or null to plan on what the sensors have seen */
  NavigationCycle(const NavigationParameters& parameters,
                  const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map);

  /** Drives through these poses, map frame; the robot stops at the last one and takes up its
   * heading. */
  void setGoals(std::vector<mrpt::math::TPose2D> goals);

  /** A sensor that must deliver: the robot does not move before it has, nor when it falls silent.
   * Sensors that are not announced are watched from their first measurement on. */
  void expectSensor(SensorKind kind, const std::string& label) {
    surroundings_.expectSensor(kind, label);
  }

  /** Runs one cycle. The record is valid until the next call. */
  const CycleRecord& step(const SensorFrame& frame);

  /** Somebody else has stopped the robot: the next command starts from standstill. */
  void noteStopped() { noteSent({}); }
  /** Not the record's command was sent, but this one: the next one starts from it. */
  void noteSent(const mrpt::math::TTwist2D& command) { record_.motion.command = command; }
  /** From sensing until the command is sent, as measured: the guard counts on it. */
  void noteComputing(double time_s) {
    if (guard_) guard_->setComputing(time_s);
  }

  const Surroundings& surroundings() const { return surroundings_; }

 private:
  void move(const mrpt::math::TTwist2D& base);
  mrpt::math::TTwist2D commandBase(const mrpt::math::TTwist2D& measured) const;

  RobotLimits limits_;
  double period_s_;
  Surroundings surroundings_;
  Route route_;
  MoverForecast movers_;
  ApproachSpeed approach_;
  MotionPlanner motionPlanner_;
  std::optional<MotionGuard> guard_;
  CycleRecord record_;
};

}  // namespace bslnav
