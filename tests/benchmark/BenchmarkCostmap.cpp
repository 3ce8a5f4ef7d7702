#include <benchmark/benchmark.h>
#include <bslnav/costmap/LayeredCostmap.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace bslnav {
namespace {

using mrpt::math::TPose2D;

constexpr double kDegree = 3.14159265358979323846 / 180.0;

/** Distance along a ray to an axis-aligned box, from within or without; `far_m` if it misses. */
double toBox(double x, double y, double cosine, double sine, const double (&box)[4], double far_m) {
  double enter = -far_m, leave = far_m;
  const double from[] = {x, y}, direction[] = {cosine, sine};
  for (int axis = 0; axis < 2; ++axis) {
    const double a = (box[axis] - from[axis]) / direction[axis],
                 b = (box[axis + 2] - from[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (leave < 0.0 || enter > leave) return far_m;
  return enter > 0.0 ? enter : leave;
}

/** A 270° scan in a room of 8 m × 6 m with four boxes: ranges from 1 to 5 m. */
PlanarScan roomScan(const TPose2D& pose, int beams) {
  constexpr double kRoom[][4] = {{-4.0, -3.0, 4.0, 3.0},
                                 {1.2, 1.0, 1.6, 1.8},
                                 {-2.5, 1.5, -2.0, 2.0},
                                 {2.5, -1.5, 3.0, -1.0},
                                 {-1.5, -2.0, -1.2, -1.2}};
  mrpt::obs::CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(270.0 * kDegree);
  scan.maxRange = 10.0f;
  scan.resizeScan(static_cast<std::size_t>(beams));
  for (int i = 0; i < beams; ++i) {
    const double angle = pose.phi + 270.0 * kDegree * (static_cast<double>(i) / (beams - 1) - 0.5);
    double range = 10.0;
    for (const auto& box : kRoom)
      range = std::min(range, toBox(pose.x, pose.y, std::cos(angle), std::sin(angle), box, 10.0));
    scan.setScanRange(static_cast<std::size_t>(i), static_cast<float>(range));
    scan.setScanRangeValidity(static_cast<std::size_t>(i), true);
  }
  PlanarScan result;
  result.assign(scan);
  return result;
}

struct Frame {
  TPose2D pose;
  std::vector<PlanarScan> scans;
};

/** One lap on a circle of radius 0.4 m, 40 cycles: the robot enters a new cell in most of them. */
std::vector<Frame> lap(int beams) {
  std::vector<Frame> frames;
  for (int i = 0; i < 40; ++i) {
    const double a = 9.0 * kDegree * i;
    const TPose2D pose(0.4 * std::cos(a), 0.4 * std::sin(a), a);
    frames.push_back({pose, {roomScan(pose, beams)}});
  }
  return frames;
}

void BM_Inflation_Full(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  ObstacleLayer obstacles({}, {}, CostGrid(size, size, 0.05, -size * 0.025, -size * 0.025));
  obstacles.update({0.0, 0.0, 0.0}, {roomScan({0.0, 0.0, 0.0}, 1080)});
  CostGrid base = obstacles.grid(), inflated = base;
  for (auto& cost : base)
    if (cost == kUnknownCost) cost = kFreeCost;
  InflationLayer inflation({}, 0.25, 0.05);
  for (auto _ : state) {
    inflation.apply(base, base.bounds(), inflated);
    benchmark::DoNotOptimize(inflated.row(0));
    benchmark::ClobberMemory();
  }
}
BENCHMARK(BM_Inflation_Full)->Arg(200)->Unit(benchmark::kMicrosecond);

void BM_ObstacleLayer_MarkAndClear(benchmark::State& state) {
  const auto frames = lap(static_cast<int>(state.range(0)));
  ObstacleLayer obstacles({}, {}, CostGrid(200, 200, 0.05, -5.0, -5.0));
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& frame = frames[i++ % frames.size()];
    benchmark::DoNotOptimize(obstacles.update(frame.pose, frame.scans));
  }
}
BENCHMARK(BM_ObstacleLayer_MarkAndClear)->Arg(1080)->Unit(benchmark::kMicrosecond);

void BM_LayeredCostmap_Update(benchmark::State& state) {
  const auto frames = lap(static_cast<int>(state.range(0)));
  LayeredCostmap costmap({}, {}, nullptr, Extent::Rolling);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& frame = frames[i++ % frames.size()];
    costmap.update(frame.pose, frame.scans, {});
    benchmark::ClobberMemory();
  }
}
BENCHMARK(BM_LayeredCostmap_Update)->Arg(1080)->Unit(benchmark::kMicrosecond);

/** The same drive on a whole map: what is outside the sensor's range must cost nothing. */
void BM_LayeredCostmap_UpdateWholeMap(benchmark::State& state) {
  const auto frames = lap(1080);
  const float half_m = static_cast<float>(state.range(0)) * 0.025f;
  auto map =
      std::make_shared<mrpt::maps::COccupancyGridMap2D>(-half_m, half_m, -half_m, half_m, 0.05f);
  map->fill(0.9f);
  LayeredCostmap costmap({}, {}, map, Extent::WholeMap);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& frame = frames[i++ % frames.size()];
    costmap.update(frame.pose, frame.scans, {});
    benchmark::ClobberMemory();
  }
}
BENCHMARK(BM_LayeredCostmap_UpdateWholeMap)->Arg(200)->Arg(1000)->Unit(benchmark::kMicrosecond);

void BM_BlindSpotLayer(benchmark::State& state) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> position(-4.0, 4.0);
  std::vector<DangerZone> zones(static_cast<std::size_t>(state.range(0)));
  for (auto& zone : zones) {
    zone.centre.x = position(random);
    zone.centre.y = position(random);
    zone.radius_m = 1.3;  // 0.56 m/s braking with 0.5 m/s², L = 0.8 m, X_off = 0.2 m
  }
  CostGrid costs(200, 200, 0.05, -5.0, -5.0);
  for (auto _ : state) {
    benchmark::DoNotOptimize(addDangerZones(zones, costs));
    benchmark::ClobberMemory();
  }
}
BENCHMARK(BM_BlindSpotLayer)->Arg(10)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace bslnav
