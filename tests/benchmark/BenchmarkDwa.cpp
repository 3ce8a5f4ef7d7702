#include <benchmark/benchmark.h>
#include <bslnav/planning/DwaPlanner.h>

#include <random>

namespace bslnav {
namespace {

using mrpt::math::TPoint2D;

constexpr double kResolution_m = 0.05;

/** 200×200 cells with boxes of 0.1 m to 0.5 m and walls of one cell, but for a lane of 1 m each
 * side of the robot's path, inflated. */
CostGrid clutter(InflationLayer& inflation) {
  CostGrid base(200, 200, kResolution_m, -5.0, -5.0);
  std::mt19937 random(1);
  std::uniform_int_distribution<int> position(0, 199), size(2, 10);
  for (int i = 0; i < 90; ++i) {
    const int x0 = position(random), y0 = position(random), w = size(random), h = size(random);
    for (int y = y0; y < std::min(200, y0 + h); ++y)
      for (int x = x0; x < std::min(200, x0 + w); ++x)
        if (std::abs(base.idx2y(y)) > 1.0) base.at(x, y) = kLethalCost;
  }
  for (int x = 0; x < 200; ++x)
    base.at(x, base.cellY(1.7)) = base.at(x, base.cellY(-1.7)) = kLethalCost;
  for (int x = 110; x < 150; x += 12)
    base.at(x, base.cellY(0.8)) = base.at(x, base.cellY(-0.9)) = kLethalCost;
  CostGrid costs = base;
  inflation.apply(base, base.bounds(), costs);
  return costs;
}

Footprint rectangle() { return {0.0, {{0.3, 0.25}, {-0.3, 0.25}, {-0.3, -0.25}, {0.3, -0.25}}}; }

void BM_Dwa_Plan(benchmark::State& state, const Footprint& footprint) {
  InflationLayer inflation({0.55, 10.0}, footprint.inscribedRadius_m(), kResolution_m);
  const CostGrid costs = clutter(inflation);
  std::vector<TPoint2D> path;
  for (int i = 0; i < 100; ++i) path.emplace_back(0.05 * i, 0.1 * std::sin(0.05 * i));
  DwaPlanner planner({}, {}, FootprintCover(footprint, kResolution_m, inflation), 0.1);
  const DwaInput input{{0.0, 0.0, 0.1}, {0.5, 0.0, 0.0}, path, {3.0, 0.1}, 0.0};
  double steps = 0.0, admissible = 0.0;
  for (auto _ : state) {
    const DwaResult& result = planner.plan(input, costs);
    benchmark::DoNotOptimize(result.best);
  }
  for (const Candidate& candidate : planner.plan(input, costs).candidates) {
    steps += candidate.steps;
    admissible += candidate.verdict == Candidate::Verdict::Admissible;
  }
  state.counters["admissible"] = admissible;
  state.counters["steps/s"] = benchmark::Counter(steps * static_cast<double>(state.iterations()),
                                                 benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(BM_Dwa_Plan, circle, Footprint{})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BM_Dwa_Plan, polygon, rectangle())->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bslnav
