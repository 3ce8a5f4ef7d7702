#include <bslnav/navigation/CycleRecord.h>
#include <bslnav/navigation/MotionGuard.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

constexpr double kStanding_mps = 0.02;

double magnitude(const mrpt::math::TTwist2D& twist) { return std::abs(speedOf(twist)); }

}  // namespace

const char* nameOf(GuardRecord::Lapse lapse) {
  static constexpr const char* kNames[] = {"", "creeping", "surprised", "blind"};
  return kNames[static_cast<int>(lapse)];
}

const Guard& MotionGuard::begin(const CycleRecord& record, const Frontier& frontier,
                                double frontierStamp_s) {
  guard_.begin(record.mapFromRobot, frontier, std::max(0.0, record.time_s - frontierStamp_s),
               creeping_);
  return guard_;
}

void MotionGuard::finish(const mrpt::math::TTwist2D& base, const Frontier& frontier,
                         CycleRecord& record) {
  record.guard = {};
  record.guard.active = true;
  auto& command = record.motion.command;
  if (!guard_.admits(command)) {
    const auto slowest = brakeAlongArc(base, limits_, period_s_);
    command = limited(guard_.capped(command, slowest), base, limits_, period_s_);
    if (!guard_.admits(command)) command = slowest;
    record.guard.capped = true;
  }
  certify(frontier, record);
  watchStanding(record);
}

void MotionGuard::finishBlind(CycleRecord& record) {
  record.guard = {};
  record.guard.active = true;
  creeping_ = false;
  refusedSince_s_ = -1.0;
  if (magnitude(record.motion.command) < kStanding_mps) return;
  record.guard.lapse = GuardRecord::Lapse::Blind;
  record.guard.impact_mps = magnitude(record.motion.command);
}

void MotionGuard::certify(const Frontier& frontier, CycleRecord& record) const {
  GuardRecord& g = record.guard;
  const auto& command = record.motion.command;
  const GuardVerdict verdict = guard_.judge(command);
  g.bound_mps = guard_.bound_mps(command);
  g.slack_m = verdict.slack_m;
  const double speed = magnitude(command);
  const auto& robot = guard_.robot();
  g.reachAtStop_m = guard_.parameters().personSpeed_mps *
                    (speed < 1e-3 ? 0.0 : robot.reaction_s + speed / robot.deceleration_mps2);
  for (const FrontierPoint& p : frontier)
    ++(p.kind == FrontierPoint::Kind::Hidden ? g.hidden : g.seen);
  if (verdict.binding >= 0) g.binding = frontier[static_cast<std::size_t>(verdict.binding)];
  const double enough_m = -std::min(guard_.parameters().noise_m, guard_.parameters().margin_m);
  if (verdict.slack_m > enough_m || speed < kStanding_mps) return;
  g.impact_mps = verdict.impact_mps;
  g.lapse = creeping_ && speed <= guard_.parameters().creepSpeed_mps + 1e-3
                ? GuardRecord::Lapse::Creeping
                : GuardRecord::Lapse::Surprised;
}

/** Lets the robot creep when it has stood for a while because nothing else was admissible, until
 * something is. */
void MotionGuard::watchStanding(CycleRecord& record) {
  const bool stands = magnitude(record.motion.command) < kStanding_mps;
  const bool planned = record.motion.planned, capped = record.guard.capped;
  if (refusedSince_s_ >= 0.0 && stands && !planned && !capped) return;  // turns on the spot
  const auto guarded = [](const Candidate& c) { return c.verdict == Candidate::Verdict::Guarded; };
  const auto& candidates = record.dwa.candidates;
  const bool refused =
      record.guard.lapse == GuardRecord::Lapse::Creeping ||
      (stands &&
       (capped || (planned && std::any_of(candidates.begin(), candidates.end(), guarded))));
  if (!refused)
    refusedSince_s_ = -1.0;
  else if (refusedSince_s_ < 0.0)
    refusedSince_s_ = record.time_s;
  creeping_ = refused && guard_.parameters().creepSpeed_mps > 0.0 &&
              record.time_s - refusedSince_s_ >= guard_.parameters().creepAfter_s - 1e-9;
}

}  // namespace bslnav
