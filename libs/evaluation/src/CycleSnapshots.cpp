#include <bslnav/evaluation/CycleSnapshots.h>
#include <bslnav/evaluation/PictureStyles.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <utility>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

constexpr int kWidth_px = 900, kHeight_px = 620;  // of a picture

std::vector<TPoint2D> rolloutOf(const Candidate& candidate, const DwaResult& dwa,
                                const CostGrid& costs) {
  std::vector<TPoint2D> points;
  for (const auto& pose : rolloutPoses(candidate.twist(), dwa.setup, candidate.steps, costs))
    points.emplace_back(pose.x, pose.y);
  return points;
}

/** Every `stride`-th candidate's rollout; costs from 0 for the best of them to 1 for the worst. */
std::vector<CandidateLine> candidateLines(const DwaResult& dwa, const CostGrid& costs,
                                          std::size_t stride) {
  std::vector<CandidateLine> lines;
  double best = std::numeric_limits<double>::infinity(), worst = -best;
  for (std::size_t i = 0; i < dwa.candidates.size(); i += stride) {
    const Candidate& candidate = dwa.candidates[i];
    const bool rejected = candidate.verdict != Candidate::Verdict::Admissible;
    lines.push_back({rolloutOf(candidate, dwa, costs), candidate.total, rejected});
    if (rejected) continue;
    best = std::min(best, candidate.total);
    worst = std::max(worst, candidate.total);
  }
  for (CandidateLine& line : lines)
    line.cost = worst > best ? (line.cost - best) / (worst - best) : 0.0;
  return lines;
}

/** Where somebody may step out, and what decides about the robot's speed. */
void drawGuard(MapPicture& picture, const CycleSnapshot& snapshot) {
  for (const FrontierPoint& p : snapshot.frontier) {
    const bool hidden = p.kind == FrontierPoint::Kind::Hidden;
    picture.disc({p.x_m, p.y_m}, 0.04, hidden ? style::kFrontier : style::kMayWalk,
                 hidden ? "somebody may step out" : "somebody may walk off");
  }
  const auto& pose = snapshot.record.mapFromRobot;
  if (const auto& binding = snapshot.record.guard.binding)
    picture.segment({pose.x, pose.y}, {binding->x_m, binding->y_m}, style::kBinding,
                    "binds the speed");
}

/** Moves an interval of at most `length` around `middle` into [lowest, highest]. */
std::pair<double, double> within(double lowest, double highest, double middle, double length) {
  length = std::min(length, highest - lowest);
  const double from = std::clamp(middle - 0.5 * length, lowest, highest - length);
  return {from, from + length};
}

}  // namespace

MapBounds snapshotWindow(const TPoint2D& centre, const MapBounds& limits) {
  const auto [xMin_m, xMax_m] = within(limits.xMin_m, limits.xMax_m, centre.x, 8.0);
  const auto [yMin_m, yMax_m] = within(limits.yMin_m, limits.yMax_m, centre.y, 6.0);
  return {xMin_m, yMin_m, xMax_m, yMax_m};
}

void drawSnapshot(MapPicture& picture, const CycleSnapshot& snapshot, const Footprint& footprint) {
  const CycleRecord& record = snapshot.record;
  picture.costs(snapshot.costs);
  if (record.motion.planned)
    picture.candidates(candidateLines(record.dwa, snapshot.costs, 7), "J, best to worst");
  picture.polyline(record.path, style::kGlobalPath, "global path");
  if (record.motion.planned && record.dwa.best >= 0)
    picture.polyline(rolloutOf(record.dwa.candidates[static_cast<std::size_t>(record.dwa.best)],
                               record.dwa, snapshot.costs),
                     style::kChosen, "chosen");
  drawGuard(picture, snapshot);
  for (const auto& zone : record.dangerZones)
    picture.disc(zone.centre, zone.radius_m, style::kDangerZone, "danger zone");
  for (const auto& person : snapshot.people)
    picture.disc(person.position, person.radius_m, style::kPerson, "person");
  picture.outline(record.mapFromRobot, footprint, style::kRobot, "robot");
}

void CycleSnapshots::add(const CycleSnapshot& snapshot, const MapBounds& limits) {
  const CycleRecord& record = snapshot.record;
  MapPicture picture("", "", snapshotWindow({record.mapFromRobot.x, record.mapFromRobot.y}, limits),
                     {kWidth_px, kHeight_px, false});
  if (!everything_) everything_.emplace("", "", limits);
  for (MapPicture* target : {&picture, &*everything_}) drawSnapshot(*target, snapshot, footprint_);

  char caption[96];
  const int written = std::snprintf(caption, sizeof caption, "t = %.1f s, %.2f m/s", record.time_s,
                                    speedOf(record.twist));
  if (record.guard.active)
    std::snprintf(caption + written, sizeof caption - static_cast<std::size_t>(written),
                  ", bound %.2f m/s", record.guard.bound_mps);
  tiles_.push_back({picture.finished(), caption});
}

void CycleSnapshots::save(const std::string& path, const std::string& title) const {
  const Picture legend = everything_ ? everything_->legend(2 * kWidth_px) : Picture{};
  tiled(tiles_, 2, title, legend).save(path);
}

}  // namespace bslnav
