#pragma once

#include <bslnav/evaluation/RunSummary.h>
#include <bslnav/navigation/NavigationCycle.h>
#include <bslnav/pictures/MapPicture.h>
#include <bslnav/pictures/PictureTiles.h>

#include <string>
#include <vector>

namespace bslnav {

/** A person to draw: where, and how wide. */
struct SnapshotPerson {
  mrpt::math::TPoint2D position;
  double radius_m = 0.25;
};

/** Pictures of single control cycles: local cost map, candidates, chosen rollout, global path,
 * danger zones. */
class CycleSnapshots {
 public:
  explicit CycleSnapshots(const Footprint& footprint) : footprint_(footprint) {}

  /** Draws a cycle. @param limits what may be shown at most */
  void add(const CycleRecord& record, const NavigationCycle& cycle,
           const std::vector<SnapshotPerson>& people, const MapBounds& limits);

  bool empty() const { return tiles_.empty(); }
  /** All snapshots in rows of two, with one legend. @throws Error (Run) when the file cannot be
   * written */
  void save(const std::string& path, const std::string& title) const;

 private:
  Footprint footprint_;
  std::vector<PictureTile> tiles_;
  Picture legend_;  // of the snapshot that shows the most
};

}  // namespace bslnav
