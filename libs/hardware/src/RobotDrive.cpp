#include <bslnav/hardware/RobotDrive.h>
#include <mrpt/core/exceptions.h>

#include <cmath>
#include <limits>
#include <utility>

namespace bslnav {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr mrpt::math::TPose2D kNowhere{kNan, kNan, kNan};

bool isFinite(const mrpt::math::TPose2D& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.phi);
}

/** Tells a base to stop, however a block is left. */
struct StopsAtTheEnd {
  Base& base;
  ~StopsAtTheEnd() { base.stop(); }
};

bool isEnd(const CycleRecord& record, double timeLimit_s, DriveEnd& end) {
  if (record.motion.mode == MotionMode::Arrived)
    end = {DriveEnd::Kind::Arrived, ""};
  else if (record.motion.mode == MotionMode::Failed)
    end = {DriveEnd::Kind::GaveUp, "gave up: " + reasonOf(record)};
  else if (timeLimit_s > 0.0 && record.time_s >= timeLimit_s)
    end = {DriveEnd::Kind::TimeLimit, "not at the goal within the time limit"};
  else
    return false;
  return true;
}

}  // namespace

void DriveParameters::describe(ConfigSection& section) {
  section.number("watchdog_s", watchdog.loop_s, {0.02, 10.0}, "s",
                 "a control loop that is silent for so long makes the watchdog stop the base");
  section.number("watchdog_sensors_s", watchdog.sensors_s, {0.05, 60.0}, "s",
                 "so do sensors that say nothing usable for so long");
  section.number("watchdog_pose_s", watchdog.pose_s, {0.05, 60.0}, "s",
                 "and a pose that is not known for so long");
  section.number("pose_max_age_s", poseMaxAge_s, kPositive, "s",
                 "an older state of the base is none: the robot stops");
  section.number("lost_above_m", lostAbove_m, kPositive, "m",
                 "with a position whose standard deviation is above this the robot stops");
}

RobotDrive::RobotDrive(NavigationCycle& cycle, Base& base, Sensors& sensors,
                       Localization* localization, const DriveParameters& parameters,
                       double period_s, DriveClock clock)
    : cycle_(cycle),
      base_(base),
      sensors_(sensors),
      localization_(localization),
      parameters_(parameters),
      period_s_(period_s),
      clock_(std::move(clock)) {}

DriveEnd RobotDrive::run(const Observer& observer) {
  const StopsAtTheEnd stops{base_};
  try {
    return loop(observer);
  } catch (const std::exception& problem) {
    base_.stop();
    return {DriveEnd::Kind::Failed, mrpt::exception_to_str(problem)};
  }
}

DriveEnd RobotDrive::loop(const Observer& observer) {
  Watchdog watchdog(base_, parameters_.watchdog);
  PaceKeeper pace(period_s_);
  for (DriveEnd end{};;) {
    pace.wait();
    problem_ = watchdog.tripped();
    if (!problem_.empty()) {
      problem_ = "the watchdog stopped the base: nothing from " + problem_;
      cycle_.noteStopped();
    }
    sense();
    cycle_.noteComputing(pace.computing_s());
    const CycleRecord& record = cycle_.step(frame_);
    const auto sent = pace.paced(record.motion.command);
    cycle_.noteSent(sent);
    base_.drive(sent);
    pace.sent();
    watchdog.heard(Watchdog::Source::Loop);
    const bool poseIsBad = record.health == CycleRecord::Health::BadPose;
    if (poseIsBad || record.health == CycleRecord::Health::Ok)
      watchdog.heard(Watchdog::Source::Sensors);
    if (!poseIsBad) watchdog.heard(Watchdog::Source::Pose);
    if (observer && !observer({record, frame_, pace, problem_}))
      return {DriveEnd::Kind::Interrupted, "interrupted"};
    if (isEnd(record, parameters_.timeLimit_s, end)) return end;
  }
}

void RobotDrive::sense() {
  frame_.afterGap = clock_.followJumps();
  frame_.time_s = clock_.time_s();
  frame_.startTime_s = clock_.startTime_s();
  sensors_.collect(frame_);
  const BaseState state = base_.state();
  frame_.odometry = state.odometry;
  frame_.twist = state.twist;
  if (frame_.afterGap && problem_.empty()) problem_ = "the clock jumped";
  if (!state.halt.empty() && problem_.empty()) problem_ = "the base stands: " + state.halt;
  frame_.mapFromRobot = locate(state);
}

mrpt::math::TPose2D RobotDrive::locate(const BaseState& state) {
  const auto nowhere = [this](const std::string& why) {
    if (problem_.empty()) problem_ = why;
    return kNowhere;
  };
  const double age_s = frame_.time_s + frame_.startTime_s - state.stamp_s;
  if (age_s > parameters_.poseMaxAge_s) return nowhere("nothing new from the base");
  if (!isFinite(state.odometry)) return nowhere("the base's odometry is no number");
  if (!localization_) return state.mapFromRobot ? *state.mapFromRobot : nowhere("no pose");
  const auto pose = localization_->update(frame_);
  if (localization_->spread_m() > parameters_.lostAbove_m) return nowhere("the robot is lost");
  return pose;
}

}  // namespace bslnav
