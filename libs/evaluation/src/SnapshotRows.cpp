#include "SnapshotRows.h"

#include <bslnav/evaluation/CycleSnapshots.h>

#include <algorithm>

#include "NumberText.h"

namespace bslnav {
namespace {

constexpr std::size_t kMostColumns = 4;
constexpr int kWidestTile_px = 580;

/** Up to four of the instants that at least one run reached, evenly chosen. */
std::vector<std::size_t> chosenInstants(const std::vector<NominalRun>& runs) {
  std::size_t reached = 0;
  for (const NominalRun& run : runs) reached = std::max(reached, run.trace.snapshots.size());
  const std::size_t count = std::min(reached, kMostColumns);
  std::vector<std::size_t> instants;
  for (std::size_t i = 0; i < count; ++i)
    instants.push_back(count < 2 ? 0 : i * (reached - 1) / (count - 1));
  return instants;
}

/** A bar of one metre in the lower left corner. */
void drawScale(MapPicture& picture, const MapBounds& window) {
  const mrpt::math::TPoint2D from{window.xMin_m + 0.3, window.yMin_m + 0.3};
  const mrpt::math::TPoint2D to{from.x + 1.0, from.y};
  picture.segment(from, to, {palette::kWhite, 7.0, false}, "");
  picture.segment(from, to, {palette::kInk, 3.5, false}, "");
  picture.note({to.x, to.y - 0.06}, "1 m");
}

Picture blank(int width, int height) {
  return {width, height,
          std::vector<std::uint8_t>(
              3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255)};
}

}  // namespace

SnapshotRows::SnapshotRows(const std::vector<NominalRun>& runs, const MapBounds& limits,
                           int width_px, int gap_px)
    : limits_(limits),
      legendWidth_px_(width_px - 2 * gap_px),
      instants_(chosenInstants(runs)),
      everything_("", "", limits) {
  if (instants_.empty()) return;
  const int columns = static_cast<int>(instants_.size());
  tileWidth_px_ = std::min(kWidestTile_px, (width_px - gap_px) / columns - gap_px);
  for (const NominalRun& run : runs)
    for (const std::size_t instant : instants_) add(run, instant);
}

void SnapshotRows::add(const NominalRun& run, std::size_t instant) {
  const std::string method = "Method " + std::to_string(run.entry.method);
  if (instant >= run.trace.snapshots.size()) {
    tiles_.push_back({blank(1, 1), method + ": " + nameOf(run.summary.outcome) +
                                       numberText(" at %.1f s", run.summary.duration_s)});
    return;
  }
  const CycleSnapshot& snapshot = run.trace.snapshots[instant];
  const auto& pose = snapshot.record.mapFromRobot;
  const MapBounds window = snapshotWindow({pose.x, pose.y}, limits_);
  MapPicture picture("", "", window, {tileWidth_px_, 2 * tileWidth_px_, false, false});
  for (MapPicture* target : {&picture, &everything_})
    drawSnapshot(*target, snapshot, run.entry.setup.navigation.footprint);
  drawScale(picture, window);
  tiles_.push_back(
      {picture.finished(), method + numberText(", t = %.1f s", snapshot.record.time_s) +
                               numberText(", %.2f m/s", speedOf(snapshot.record.twist))});
}

Picture SnapshotRows::finished() const {
  return tiled(tiles_, static_cast<int>(instants_.size()),
               "Cost maps and candidates at the same instants",
               everything_.legend(legendWidth_px_));
}

}  // namespace bslnav
