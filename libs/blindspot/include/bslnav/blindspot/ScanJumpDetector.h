#pragma once

#include <bslnav/blindspot/BlindSpot.h>
#include <bslnav/config/ConfigSection.h>
#include <bslnav/costmap/PlanarScan.h>

#include <vector>

namespace bslnav {

/** What a beam says that met no surface. */
enum class NoReturn {
  MaxRange,  ///< the view is free up to the sensor's maximum range
  Skip       ///< nothing: it makes no jump and parts its neighbours
};

struct ScanJumpParameters {
  double threshold_m = 1.0;  ///< Z_th
  NoReturn noReturn = NoReturn::MaxRange;

  void describe(ConfigSection& section);
};

/** Finds blind spots as range jumps between neighbouring beams (paper, eq. 3: conventional).
 *
 * Where two neighbours differ by more than the threshold, the nearer one is the boundary; a beam
 * that is the nearer one on both of its sides counts once. A dropped beam is as if it were not
 * there: its neighbours are compared with each other, because what lies between them is not seen
 * either, and sensors often lose the very beam that grazes an edge. A scan of the full circle is
 * closed. */
class ScanJumpDetector {
 public:
  explicit ScanJumpDetector(const ScanJumpParameters& parameters = {}) : parameters_(parameters) {}

  /** Blind spots of all scans in the order of scans and beams; valid until the next call. */
  const std::vector<BlindSpot>& detect(const std::vector<PlanarScan>& scans);

 private:
  void detectIn(const PlanarScan& scan);

  ScanJumpParameters parameters_;
  std::vector<BlindSpot> blindSpots_;
};

}  // namespace bslnav
