#pragma once

#include <bslnav/evaluation/RunSummary.h>
#include <bslnav/navigation/NavigationCycle.h>
#include <bslnav/pictures/MapPicture.h>
#include <bslnav/pictures/PictureTiles.h>

#include <optional>
#include <string>
#include <vector>

namespace bslnav {

/** A person to draw: where, and how wide. */
struct SnapshotPerson {
  mrpt::math::TPoint2D position;
  double radius_m = 0.25;
};

/** A control cycle, kept to be drawn. */
struct CycleSnapshot {
  CycleRecord record;
  CostGrid costs;  ///< the local ones
  std::vector<SnapshotPerson> people;
  Frontier frontier{};  ///< of the guard
};

/** Draws local cost map, candidates, chosen rollout, global path, danger zones, people and robot.
 *
 * The candidates' costs are drawn from 0, the cycle's best, to 1, its worst, so that one legend
 * serves several cycles. */
void drawSnapshot(MapPicture& picture, const CycleSnapshot& snapshot, const Footprint& footprint);

/** 8 m x 6 m around a point; moved, and made smaller where necessary, to stay within limits. */
MapBounds snapshotWindow(const mrpt::math::TPoint2D& centre, const MapBounds& limits);

/** Pictures of single control cycles for one page. */
class CycleSnapshots {
 public:
  explicit CycleSnapshots(const Footprint& footprint) : footprint_(footprint) {}

  /** Draws a cycle. @param limits what may be shown at most */
  void add(const CycleSnapshot& snapshot, const MapBounds& limits);

  bool empty() const { return tiles_.empty(); }
  /** All snapshots in rows of two, with one legend. @throws Error (Run) when the file cannot be
   * written */
  void save(const std::string& path, const std::string& title) const;

 private:
  Footprint footprint_;
  std::vector<PictureTile> tiles_;
  std::optional<MapPicture> everything_;  // for its legend only
};

}  // namespace bslnav
