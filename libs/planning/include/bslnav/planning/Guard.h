#pragma once

#include <bslnav/blindspot/Frontier.h>
#include <bslnav/config/ConfigSection.h>
#include <bslnav/planning/RobotLimits.h>
#include <mrpt/math/TPose2D.h>
#include <mrpt/math/TTwist2D.h>

#include <vector>

namespace bslnav {

/** The guard: only velocities from which the robot stands before anybody who may step out can reach
 * it. */
struct GuardParameters {
  bool enabled = false;
  double personSpeed_mps = 4.0 / 3.6;  ///< v_h: nobody walks faster
  double latency_s = 0.1;              ///< from a command to its effect, besides the period
  double margin_m = 0.08;  ///< noise of ranges and pose, half a cell of the grid of hidden people
  double noise_m = 0.04;   ///< so much of the margin may noise use up without a lapse
  double creepAfter_s = 10.0;    ///< standing so long with nothing admissible, the robot may creep
  double creepSpeed_mps = 0.04;  ///< 0: it never does

  void describe(ConfigSection& section);
};

/** What the guard needs to know of a robot. */
struct StoppingAbility {
  double radius_m;           ///< of the circle around the robot's centre that holds its outline
  double deceleration_mps2;  ///< along the arc that it drives
  double reaction_s;         ///< τ: from a measurement until it brakes: control period and latency
};

/** @param radius_m as in StoppingAbility; the reaction time is the period and the guard's latency
 */
StoppingAbility stoppingAbility(const RobotLimits& limits, const GuardParameters& guard,
                                double radius_m, double controlPeriod_s);

/** Whether somebody could reach the robot while it moves. */
struct GuardVerdict {
  bool admissible = true;
  double slack_m = 0.0;  ///< least distance that is left, over the time until it stands; negative
                         ///< when somebody could reach it; capped at kGuardReach_m
  double impact_mps = 0.0;  ///< the robot's speed when somebody could reach it first; 0: never
  int binding = -1;  ///< index of the frontier point that decides; −1 for none within reach
};
inline constexpr double kGuardReach_m = 10.0;

/** The guard's condition as it is written (share/doc/guard.md): the robot drives the command for
 * the reaction time and then brakes along the same arc; at every time until it stands, every
 * frontier point must be farther from its centre than radius + v_h·t + margin. Who has stood for a
 * while is an obstacle for a robot that creeps, and binds none.
 *
 * Pure and plain: for people with their own planner, and the oracle of Guard. Steps of 1 ms.
 *  @param command robot frame; the robot stands when (vx, vy) is zero
 *  @param age_s time since the frontier was seen */
GuardVerdict guardVerdict(const mrpt::math::TTwist2D& command,
                          const mrpt::math::TPose2D& mapFromRobot, const Frontier& frontier,
                          double age_s, const StoppingAbility& robot,
                          const GuardParameters& parameters);

/** The same condition, fast, for the many candidates of one control cycle. */
class Guard {
 public:
  static constexpr double kWorthwhile_mps = 0.1;  ///< slower than that, the path is kept to

  Guard(const GuardParameters& parameters, const RobotLimits& limits, double robotRadius_m,
        double controlPeriod_s);

  const GuardParameters& parameters() const { return parameters_; }
  const StoppingAbility& robot() const { return robot_; }

  /** What computing takes, as measured, besides the period and the configured latency. */
  void setComputing(double time_s) {
    robot_.reaction_s = period_s_ + parameters_.latency_s + time_s;
  }

  /** Takes over the situation of a cycle; keeps those frontier points that can matter.
   *  @param mayCreep up to the creeping speed, only those who are seen walking bind */
  void begin(const mrpt::math::TPose2D& mapFromRobot, const Frontier& frontier, double age_s,
             bool mayCreep);

  /** Whether the robot may creep now, as in begin(). */
  bool mayCreep() const { return mayCreep_; }
  /** Whether somebody stands so near that hardly more than creeping is admissible. */
  bool isBesideStanding() const;

  /** Whether a command may be sent. Its index is that of the frontier given to begin(). */
  bool admits(const mrpt::math::TTwist2D& command) const;
  GuardVerdict judge(const mrpt::math::TTwist2D& command) const;
  /** The same for what is sent now on the way from a velocity to a wanted one. */
  bool admitsTowards(const mrpt::math::TTwist2D& wanted, const mrpt::math::TTwist2D& from) const {
    return admits(limited(wanted, from, limits_, period_s_));
  }

  /** The highest speed up to the robot's own at which the arc of this command is admissible at it
   * and at all lower speeds, to 1 cm/s. */
  double bound_mps(const mrpt::math::TTwist2D& arc) const;

  /** The command itself if admissible, else the fastest admissible one on its arc between it and
   * `slowest`, else `slowest`. For commands of any planner.
   *  @param slowest braking as hard as the robot can, for example brakeAlongArc() */
  mrpt::math::TTwist2D capped(const mrpt::math::TTwist2D& command,
                              const mrpt::math::TTwist2D& slowest) const;

 private:
  bool isCreep(double speed_mps) const { return speed_mps <= parameters_.creepSpeed_mps + 1e-3; }
  /** Points that the promise at a speed minds, and those that may refuse it, are the first so many.
   */
  std::size_t promised(double speed_mps) const {
    return isCreep(speed_mps) ? walking_ : x_m_.size();
  }
  std::size_t refusing(double speed_mps) const {
    return mayCreep_ && isCreep(speed_mps) ? seen_ : promised(speed_mps);
  }
  float nearest(float x_m, float y_m, std::size_t count, std::size_t* which = nullptr) const;

  GuardParameters parameters_;
  RobotLimits limits_;
  double period_s_;
  StoppingAbility robot_;
  mrpt::math::TPose2D pose_;
  double age_s_ = 0.0;
  bool mayCreep_ = false;
  std::vector<float> x_m_, y_m_;
  std::vector<int> index_;
  std::size_t seen_ = 0, walking_ = 0;  // the first points are Seen, the next Hidden
  float distanceNow_m_ = 0.0f;
};

/** The command of one control period that slows down as hard as the limits allow and keeps to the
 * arc that the robot drives, as far as the limits of its turn allow. */
mrpt::math::TTwist2D brakeAlongArc(const mrpt::math::TTwist2D& current, const RobotLimits& limits,
                                   double period_s);

}  // namespace bslnav
