#include <benchmark/benchmark.h>
#include <bslnav/planning/GlobalPlanner.h>

namespace bslnav {
namespace {

constexpr double kResolution_m = 0.05;

CostGrid emptyGrid(int size) { return CostGrid(size, size, kResolution_m, 0.0, 0.0); }

/** Walls of one cell every `spacing` rows, each with a gap of three cells at alternating ends. */
CostGrid serpentine(int size, int spacing) {
  CostGrid grid = emptyGrid(size);
  for (int wall = 1; wall * spacing < size; ++wall)
    for (int x = 0; x < size; ++x) {
      const int fromGap = wall % 2 == 0 ? x : size - 1 - x;
      if (fromGap >= 3) grid.at(x, wall * spacing) = kLethalCost;
    }
  return grid;
}

/** Plans from the lower left to the upper right corner. */
void run(benchmark::State& state, const CostGrid& grid, PathResult::Status expected) {
  GlobalPlanner planner;
  const mrpt::math::TPoint2D start{grid.idx2x(1), grid.idx2y(1)};
  const mrpt::math::TPoint2D goal{grid.idx2x(grid.width() - 2), grid.idx2y(grid.height() - 2)};
  for (auto _ : state) {
    const PathResult result = planner.plan(grid, start, goal);
    if (result.status != expected) state.SkipWithError(describe(result.status));
    benchmark::DoNotOptimize(result.cost);
  }
}

void BM_GlobalPlanner_Empty(benchmark::State& state) {
  run(state, emptyGrid(static_cast<int>(state.range(0))), PathResult::Status::Found);
}
BENCHMARK(BM_GlobalPlanner_Empty)->Arg(1000)->Unit(benchmark::kMillisecond);

void BM_GlobalPlanner_Serpentine(benchmark::State& state) {
  run(state, serpentine(static_cast<int>(state.range(0)), 15), PathResult::Status::Found);
}
BENCHMARK(BM_GlobalPlanner_Serpentine)->Arg(1000)->Unit(benchmark::kMillisecond);

void BM_GlobalPlanner_Unreachable(benchmark::State& state) {
  CostGrid grid = serpentine(static_cast<int>(state.range(0)), 15);
  const int middle = grid.height() / 15 / 2 * 15;
  for (int x = 0; x < grid.width(); ++x) grid.at(x, middle) = kLethalCost;
  run(state, grid, PathResult::Status::NoPath);
}
BENCHMARK(BM_GlobalPlanner_Unreachable)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bslnav
