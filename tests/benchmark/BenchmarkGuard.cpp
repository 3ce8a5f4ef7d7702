#include <benchmark/benchmark.h>
#include <bslnav/blindspot/HiddenPeople.h>
#include <bslnav/evaluation/SimulationSetup.h>
#include <bslnav/planning/Guard.h>
#include <bslnav/simulation/LaserSensor.h>

namespace bslnav {
namespace {

const mrpt::math::TPose2D kPose{3.0, 0.0, 0.0};

/** The laser's view of S1 from before the opening. */
struct Corridor {
  Corridor() {
    Config config;
    setup.bind(config);
    config.load({dataDirectory() + "/config/scenarios/s1.ini"});
    LaserSensor laser("front", setup.lasers.at("front"), 1);
    RayScene scene(setup.world, {{setup.lasers.at("front").z_m, 1.7}});
    scan.assign(*laser.scan(scene, kPose, mrpt::Clock::fromDouble(1e9)));
  }
  SimulationSetup setup;
  PlanarScan scan;
};

void BM_HiddenPeople_Update(benchmark::State& state) {
  const Corridor corridor;
  HiddenPeople hidden({}, 0.25, corridor.setup.makeMap(), {});
  const std::vector<const PlanarScan*> views{&corridor.scan};
  double time_s = 0.0;
  for (auto _ : state) hidden.update(views, time_s += 0.1, kPose, 1.1);
  state.counters["points"] = static_cast<double>(hidden.frontier().size());
}
BENCHMARK(BM_HiddenPeople_Update)->Unit(benchmark::kMillisecond);

/** The verdicts on 20 x 40 candidates around 0.5 m/s, with or without a new frontier before. */
void candidates(benchmark::State& state, bool withFrontier) {
  const Corridor corridor;
  HiddenPeople hidden({}, 0.25, corridor.setup.makeMap(), {});
  const std::vector<const PlanarScan*> views{&corridor.scan};
  Guard guard({}, {}, 0.25, 0.1);
  double time_s = 0.0;
  hidden.update(views, time_s, kPose, 1.1);
  int admitted = 0;
  for (auto _ : state) {
    if (withFrontier) hidden.update(views, time_s += 0.1, kPose, 1.1);
    guard.begin(kPose, hidden.frontier(), 0.0, false);
    admitted = 0;
    for (int v = 0; v < 20; ++v)
      for (int w = 0; w < 40; ++w)
        admitted += guard.admits({0.03 * (v + 1), 0.0, 0.05 * (w - 19.5)});
  }
  state.counters["admitted"] = admitted;
}
void BM_Guard_Candidates(benchmark::State& state) { candidates(state, false); }
void BM_Guard_FrontierAndCandidates(benchmark::State& state) { candidates(state, true); }
BENCHMARK(BM_Guard_Candidates)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Guard_FrontierAndCandidates)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bslnav
