#pragma once

#include <bslnav/evaluation/NominalRuns.h>
#include <bslnav/pictures/MapPicture.h>
#include <bslnav/pictures/PictureTiles.h>

#include <vector>

namespace bslnav {

/** Cost maps at the same instants: a row for each run, a column for each instant that a run
 * reached; at most four. */
class SnapshotRows {
 public:
  SnapshotRows(const std::vector<NominalRun>& runs, const MapBounds& limits, int width_px,
               int gap_px);

  bool empty() const { return tiles_.empty(); }
  Picture finished() const;

 private:
  void add(const NominalRun& run, std::size_t instant);

  MapBounds limits_;
  int legendWidth_px_;
  int tileWidth_px_ = 0;
  std::vector<std::size_t> instants_;
  MapPicture everything_;  // for its legend only
  std::vector<PictureTile> tiles_;
};

}  // namespace bslnav
