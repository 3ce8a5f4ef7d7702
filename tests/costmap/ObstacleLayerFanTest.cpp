#include <bslnav/costmap/ObstacleLayer.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "CostmapTestTools.h"

namespace bslnav {
namespace {

/** 400 beams over 90° in steps of random length and range: up to 20 beams a cell near the sensor,
 * with short ones among long ones. */
PlanarScan anyDenseScan() {
  std::vector<double> ranges_m;
  while (ranges_m.size() < 400) {
    const int beams = *rc::gen::inRange(1, 30);
    const double range_m = *rc::gen::inRange(0, 8) == 0 ? std::nan("") : test::anyNumber(0.05, 5.0);
    ranges_m.insert(ranges_m.end(), static_cast<std::size_t>(beams), range_m);
  }
  return test::makeScan(ranges_m, test::kPi / 2,
                        mrpt::poses::CPose3D(0.0, 0.0, 0.0, test::anyNumber(-3.0, 3.0), 0.0, 0.0));
}

/** Each beam as a scan of its own. */
std::vector<PlanarScan> oneByOne(const PlanarScan& scan) {
  std::vector<PlanarScan> beams(scan.beam.size(), scan);
  for (std::size_t i = 0; i < beams.size(); ++i) {
    beams[i].range_m = {scan.range_m[i]};
    beams[i].cosine = {scan.cosine[i]};
    beams[i].sine = {scan.sine[i]};
    beams[i].beam = {scan.beam[i]};
  }
  return beams;
}

RC_GTEST_PROP(ObstacleLayer, ScanDoesWhatItsBeamsDoOneByOne, ()) {
  const CostGrid shape(100, 100, 0.05, -2.5, -2.5);
  ObstacleParameters parameters;
  parameters.clearFootprint = false;
  ObstacleLayer together(parameters, {}, shape), separately(parameters, {}, shape);
  const mrpt::math::TPose2D pose = test::anyPose(3.0);
  const PlanarScan scan = anyDenseScan();
  together.update(pose, {scan});
  separately.update(pose, oneByOne(scan));
  RC_ASSERT(test::same(together.grid(), separately.grid()));
}

}  // namespace
}  // namespace bslnav
