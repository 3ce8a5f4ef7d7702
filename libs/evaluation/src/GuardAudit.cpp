#include <bslnav/evaluation/GuardAudit.h>

#include <algorithm>
#include <cmath>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

constexpr double kBehind_m = 3.0;   // so far behind a jump its shadow is looked at
constexpr double kBeside_m = 0.15;  // a frontier point this near to the jump's ray is its
constexpr double kStretch_s = 5.0;  // of such a stretch of the log, one of the worst moments
constexpr double kDriving_mps = 0.05;
constexpr std::size_t kMoments = 3;

/** Whether a frontier of hidden people lies behind a jump. */
bool isBehind(const Frontier& frontier, const TPoint2D& robot, const TPoint2D& jump) {
  const TPoint2D ray = jump - robot;
  const double range = std::max(1e-6, ray.norm());
  return std::any_of(frontier.begin(), frontier.end(), [&](const FrontierPoint& p) {
    if (p.kind != FrontierPoint::Kind::Hidden) return false;
    const TPoint2D to(p.x_m - robot.x, p.y_m - robot.y);
    const double along = (to.x * ray.x + to.y * ray.y) / range - range;
    const double aside = std::abs(to.x * ray.y - to.y * ray.x) / range;
    return aside <= kBeside_m && along >= -kBeside_m && along <= kBehind_m;
  });
}

/** How many pieces hidden people's frontier has: cells that touch are of one. */
long piecesOf(const Frontier& frontier, double resolution_m) {
  std::vector<TPoint2D> left;
  for (const FrontierPoint& p : frontier)
    if (p.kind == FrontierPoint::Kind::Hidden) left.emplace_back(p.x_m, p.y_m);
  long pieces = 0;
  for (; !left.empty(); ++pieces) {
    std::vector<TPoint2D> piece{left.back()};
    left.pop_back();
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const TPoint2D centre = piece[i];
      const auto touches = [&](const TPoint2D& p) {
        return (p - centre).norm() < 1.5 * resolution_m;
      };
      const auto away =
          std::partition(left.begin(), left.end(), [&](const TPoint2D& p) { return !touches(p); });
      piece.insert(piece.end(), away, left.end());
      left.erase(away, left.end());
    }
  }
  return pieces;
}

}  // namespace

GuardAudit::GuardAudit(const NavigationParameters& parameters,
                       const std::shared_ptr<const mrpt::maps::COccupancyGridMap2D>& map)
    : parameters_(parameters),
      map_(map),
      jumps_(parameters.scanJumps),
      guard_(parameters.guard, parameters.limits, parameters.footprint.circumscribedRadius_m(),
             parameters.cycle.period_s) {}

void GuardAudit::observe(const RawlogMoment& moment) {
  const Surroundings& surroundings = moment.cycle.surroundings();
  if (!surroundings.people() || moment.record.health != CycleRecord::Health::Ok) return;
  if (!surroundings.scans().empty()) countJumps(moment);
  judgeSpeed(moment);
}

void GuardAudit::countJumps(const RawlogMoment& moment) {
  const Surroundings& surroundings = moment.cycle.surroundings();
  const mrpt::math::TPose2D& pose = moment.record.mapFromRobot;
  const Frontier& frontier = surroundings.people()->frontier();
  sums_.scans += static_cast<long>(surroundings.scans().size());
  sums_.frontiers += piecesOf(frontier, parameters_.hiddenPeople.resolution_m);
  // What the same scans would say to somebody without memory.
  HiddenPeople fresh(parameters_.hiddenPeople, parameters_.footprint.circumscribedRadius_m(), map_,
                     parameters_.costmap.map);
  std::vector<const PlanarScan*> scans;
  for (const PlanarScan& scan : surroundings.scans()) scans.push_back(&scan);
  fresh.update(scans, moment.record.time_s, pose, parameters_.guard.personSpeed_mps);
  for (const BlindSpot& spot : jumps_.detect(surroundings.scans())) {
    const TPoint2D jump = pose.composePoint(spot.position);
    const double reach = std::max(std::abs(jump.x - pose.x), std::abs(jump.y - pose.y));
    ++sums_.jumps;
    if (isBehind(frontier, {pose.x, pose.y}, jump))
      ++sums_.plausible;
    else if (reach > parameters_.hiddenPeople.reach_m)
      ++sums_.tooFar;
    else if (isBehind(fresh.frontier(), {pose.x, pose.y}, jump))
      ++sums_.seenEmpty;
    else
      ++sums_.nobodyFits;
  }
}

void GuardAudit::judgeSpeed(const RawlogMoment& moment) {
  const CycleRecord& record = moment.record;
  const double speed = std::abs(speedOf(record.twist, parameters_.limits));
  if (!(speed > kDriving_mps)) return;
  ++sums_.drivingCycles;
  const People& people = *moment.cycle.surroundings().people();
  guard_.begin(record.mapFromRobot, people.frontier(),
               std::max(0.0, record.time_s - people.stamp_s()), false);
  if (guard_.admits(record.twist)) return;
  ++sums_.exceededCycles;
  const double bound = guard_.bound_mps(record.twist), excess = speed - bound;
  sums_.mostExceeded_mps = std::max(sums_.mostExceeded_mps, excess);
  CycleSnapshot snapshot{record, moment.cycle.surroundings().localCosts(), {}, people.frontier()};
  const GuardVerdict verdict = guard_.judge(record.twist);
  snapshot.record.guard.bound_mps = bound;
  snapshot.record.guard.binding.reset();
  if (verdict.binding >= 0)
    snapshot.record.guard.binding = people.frontier()[static_cast<std::size_t>(verdict.binding)];
  keepWorst(excess, snapshot);
}

void GuardAudit::keepWorst(double excess_mps, const CycleSnapshot& snapshot) {
  const auto replace = [&](std::size_t i) {
    if (excess_mps <= excess_mps_[i]) return;
    excess_mps_.erase(excess_mps_.begin() + static_cast<std::ptrdiff_t>(i));
    worst_.erase(worst_.begin() + static_cast<std::ptrdiff_t>(i));
    excess_mps_.push_back(excess_mps);  // cycles come in the order of time
    worst_.push_back(snapshot);
  };
  const auto stretchOf = [](const CycleSnapshot& s) {
    return std::floor(s.record.time_s / kStretch_s);
  };
  if (!worst_.empty() && stretchOf(worst_.back()) == stretchOf(snapshot))
    return replace(worst_.size() - 1);
  if (worst_.size() == kMoments)
    return replace(static_cast<std::size_t>(
        std::min_element(excess_mps_.begin(), excess_mps_.end()) - excess_mps_.begin()));
  excess_mps_.push_back(excess_mps);
  worst_.push_back(snapshot);
}

}  // namespace bslnav
