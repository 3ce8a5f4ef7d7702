#include <benchmark/benchmark.h>
#include <bslnav/blindspot/DangerZones.h>
#include <bslnav/blindspot/ScanJumpDetector.h>

namespace bslnav {
namespace {

/** A scan of 270° with a jump of 3 m every 33 beams: about as many blind spots as a cluttered
 * office gives. */
PlanarScan clutteredScan(std::size_t beams) {
  mrpt::obs::CObservation2DRangeScan observation;
  observation.aperture = static_cast<float>(1.5 * M_PI);
  observation.maxRange = 30.0f;
  observation.resizeScan(beams);
  for (std::size_t i = 0; i < beams; ++i) {
    observation.setScanRange(i, i / 33 % 2 == 0 ? 2.0f : 5.0f);
    observation.setScanRangeValidity(i, true);
  }
  PlanarScan scan;
  scan.assign(observation);
  return scan;
}

void BM_ScanJumps(benchmark::State& state) {
  const std::vector<PlanarScan> scans{clutteredScan(static_cast<std::size_t>(state.range(0)))};
  ScanJumpDetector detector;
  std::size_t found = 0;
  for (auto _ : state) {
    found = detector.detect(scans).size();
    benchmark::DoNotOptimize(found);
  }
  state.counters["blind_spots"] = static_cast<double>(found);
}
BENCHMARK(BM_ScanJumps)->Arg(1080)->Unit(benchmark::kMicrosecond);

void BM_DangerZones(benchmark::State& state) {
  const std::vector<PlanarScan> scans{clutteredScan(1080)};
  ScanJumpDetector detector;
  std::vector<BlindSpot> blindSpots = detector.detect(scans);
  blindSpots.resize(static_cast<std::size_t>(state.range(0)), blindSpots.front());
  const mrpt::math::TPose2D mapFromRobot{3.0, -1.0, 0.4};
  for (auto _ : state)
    for (const BlindSpot& blindSpot : blindSpots)
      benchmark::DoNotOptimize(dangerZone(blindSpot, mapFromRobot, 0.5, DangerZoneParameters{}));
}
BENCHMARK(BM_DangerZones)->Arg(32)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace bslnav
