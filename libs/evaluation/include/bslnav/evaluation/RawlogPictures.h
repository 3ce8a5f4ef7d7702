#pragma once

#include <bslnav/evaluation/CycleSnapshots.h>
#include <bslnav/evaluation/DepthStagePage.h>
#include <bslnav/evaluation/GuardAudit.h>
#include <bslnav/evaluation/RawlogRun.h>

#include <string>
#include <vector>

namespace bslnav {

/** Gathers what the pictures of an offline evaluation show, cycle by cycle, and draws them. */
class RawlogPictures {
 public:
  RawlogPictures(const RawlogSetup& setup, const LocalizedLog& log);

  /** Draws the worst moments of an audit on a page of their own. */
  void add(const GuardAudit& audit);

  /** Takes in one cycle; draws a snapshot when one is due. */
  void observe(const RawlogMoment& moment);

  /** Writes path.png, comparison.png, snapshots.png and worst-moments.png into a directory.
   *  @returns their paths  @throws Error (Run) when a file cannot be written */
  std::vector<std::string> save(const RunSummary& summary, const std::string& directory) const;

 private:
  MapPicture pathPicture(const RunSummary& summary) const;

  const RawlogSetup& setup_;
  const LocalizedLog& log_;
  MapBounds bounds_;
  std::vector<double> time_s_, recorded_mps_, chosen_mps_, recorded_radps_, chosen_radps_,
      blindSpots_;
  std::vector<mrpt::math::TPoint2D> positions_, spots_;
  CycleSnapshots snapshots_, worst_;
  std::vector<DepthStagePage> depthStages_;  // of snapshots with depth images
  int snapshotsTaken_ = 0;
};

}  // namespace bslnav
