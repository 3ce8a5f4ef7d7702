#pragma once

#include <bslnav/navigation/GuardRecord.h>
#include <bslnav/planning/Guard.h>

#include <string>

namespace bslnav {

struct CycleRecord;

/** The guard in the control cycle: refuses candidates, has the last word on the command, lets a
 * robot creep that could not move otherwise, and writes the certificate. */
class MotionGuard {
 public:
  /** @param robotRadius_m of the circle that holds the robot's outline */
  MotionGuard(const GuardParameters& parameters, const RobotLimits& limits, double robotRadius_m,
              double controlPeriod_s)
      : limits_(limits),
        period_s_(controlPeriod_s),
        guard_(parameters, limits, robotRadius_m, controlPeriod_s) {}

  /** As Guard::setComputing(). */
  void setComputing(double time_s) { guard_.setComputing(time_s); }

  /** Takes over the situation of a cycle; what it returns judges candidates.
   *  @param frontierStamp_s when the frontier was seen */
  const Guard& begin(const CycleRecord& record, const Frontier& frontier, double frontierStamp_s);

  /** Caps the record's command and certifies what is left of it.
   *  @param base what the command starts from
   *  @param frontier as in begin() */
  void finish(const mrpt::math::TTwist2D& base, const Frontier& frontier, CycleRecord& record);

  /** Whether the robot stands because nothing is admissible, and may not creep yet: it waits, and
   * recovery has no business. */
  bool isWaiting() const { return refusedSince_s_ >= 0.0 && !creeping_; }

  /** The cycle saw nothing: its command brakes, and what it promises is not known. */
  void finishBlind(CycleRecord& record);

 private:
  void certify(const Frontier& frontier, CycleRecord& record) const;
  void watchStanding(CycleRecord& record);

  RobotLimits limits_;
  double period_s_;
  Guard guard_;
  bool creeping_ = false;
  double refusedSince_s_ = -1.0;  // below 0: not refused
};

}  // namespace bslnav
