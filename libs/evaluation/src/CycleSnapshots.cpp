#include <bslnav/evaluation/CycleSnapshots.h>
#include <bslnav/evaluation/PictureStyles.h>

#include <algorithm>
#include <cstdio>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

std::vector<TPoint2D> rolloutOf(const Candidate& candidate, const DwaResult& dwa,
                                const CostGrid& costs) {
  std::vector<TPoint2D> points;
  for (const auto& pose :
       rolloutPoses(candidate.v_mps, candidate.w_radps, dwa.setup, candidate.steps, costs))
    points.emplace_back(pose.x, pose.y);
  return points;
}

/** Every `stride`-th candidate's rollout. */
std::vector<CandidateLine> candidateLines(const DwaResult& dwa, const CostGrid& costs,
                                          std::size_t stride) {
  std::vector<CandidateLine> lines;
  for (std::size_t i = 0; i < dwa.candidates.size(); i += stride) {
    const Candidate& candidate = dwa.candidates[i];
    lines.push_back({rolloutOf(candidate, dwa, costs), candidate.total,
                     candidate.verdict != Candidate::Verdict::Admissible});
  }
  return lines;
}

MapBounds around(const mrpt::math::TPose2D& pose, const MapBounds& limits) {
  return {std::max(limits.xMin_m, pose.x - 4.0), std::max(limits.yMin_m, pose.y - 3.0),
          std::min(limits.xMax_m, pose.x + 4.0), std::min(limits.yMax_m, pose.y + 3.0)};
}

}  // namespace

void CycleSnapshots::add(const CycleRecord& record, const NavigationCycle& cycle,
                         const std::vector<SnapshotPerson>& people, const MapBounds& limits) {
  constexpr int kWidth_px = 900, kHeight_px = 620;
  MapPicture picture("", "", around(record.mapFromRobot, limits), {kWidth_px, kHeight_px, false});
  const CostGrid& costs = cycle.localCosts();
  picture.costs(costs);
  if (record.motion.planned) picture.candidates(candidateLines(record.dwa, costs, 7), "cost J");
  picture.polyline(record.path, style::kGlobalPath, "global path");
  if (record.motion.planned && record.dwa.best >= 0)
    picture.polyline(rolloutOf(record.dwa.candidates[static_cast<std::size_t>(record.dwa.best)],
                               record.dwa, costs),
                     style::kChosen, "chosen");
  for (const auto& zone : record.dangerZones)
    picture.disc(zone.centre, zone.radius_m, style::kDangerZone, "danger zone");
  for (const auto& person : people)
    picture.disc(person.position, person.radius_m, style::kPerson, "person");
  picture.outline(record.mapFromRobot, footprint_, style::kRobot, "robot");

  char caption[64];
  std::snprintf(caption, sizeof caption, "t = %.1f s, %.2f m/s", record.time_s, record.twist.vx);
  tiles_.push_back({picture.finished(), caption});
  Picture legend = picture.legend(2 * kWidth_px);
  if (legend.height >= legend_.height) legend_ = std::move(legend);
}

void CycleSnapshots::save(const std::string& path, const std::string& title) const {
  tiled(tiles_, 2, title, legend_).save(path);
}

}  // namespace bslnav
