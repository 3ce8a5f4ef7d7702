#include <benchmark/benchmark.h>
#include <bslnav/evaluation/SimulationRun.h>
#include <bslnav/simulation/Simulator.h>

#include <string>
#include <vector>

namespace bslnav {
namespace {

SimulationSetup s1(int method) {
  SimulationSetup setup;
  Config config;
  setup.bind(config);
  const std::string dir = dataDirectory() + "/config/";
  config.load({dir + "scenarios/s1.ini", dir + "methods/method" + std::to_string(method) + ".ini"});
  return setup;
}

/** The frames of a second's drive from the middle of the corridor of S1, before the opening. */
std::vector<SensorFrame> framesOf(const SimulationSetup& setup) {
  auto cameras = setup.navigation.depth.enabled ? setup.cameras : decltype(setup.cameras){};
  for (auto& [name, camera] : cameras) {
    camera.columns = 640;
    camera.rows = 480;
  }
  Simulator simulator(setup.world, setup.simulatedRobot, setup.lasers, cameras, {3.0, 0.0, 0.0}, {},
                      1);
  std::vector<SensorFrame> frames;
  for (int i = 0; i < 10; ++i) {
    SensorFrame frame;
    frame.time_s = simulator.state().time_s;
    frame.startTime_s = Simulator::kEpoch_s;
    frame.odometry = frame.mapFromRobot = simulator.state().pose;
    frame.twist = simulator.state().twist;
    for (auto& scan : simulator.senseScans()) frame.scans.push_back(std::move(scan));
    frame.depth = simulator.senseDepth();
    frames.push_back(std::move(frame));
    simulator.step({0.5, 0.0, 0.0}, 0.1);
  }
  return frames;
}

/** A whole control cycle: a scan of 683 beams, with Methods 3 to 5 a depth image of 640x480, cost
 * map of 10 m, 800 candidates; every tenth one plans a new path. */
void cycle(benchmark::State& state, int method) {
  const SimulationSetup setup = s1(method);
  auto frames = framesOf(setup);
  NavigationCycle navigation(setup.navigation, setup.makeMap());
  navigation.setGoals(setup.scenario.goals);
  std::size_t next = 0, blindSpots = 0;
  for (auto _ : state) {
    SensorFrame& frame = frames[next++ % frames.size()];
    const CycleRecord& record = navigation.step(frame);
    benchmark::DoNotOptimize(record.motion.command);
    blindSpots += record.blindSpots.size();
    frame.time_s += 1.0;  // once more a second later: the clock began earlier
    frame.startTime_s -= 1.0;
  }
  state.counters["blind_spots"] =
      benchmark::Counter(static_cast<double>(blindSpots), benchmark::Counter::kAvgIterations);
}
void BM_Cycle_Method1(benchmark::State& state) { cycle(state, 1); }
void BM_Cycle_Method2(benchmark::State& state) { cycle(state, 2); }
void BM_Cycle_Method3(benchmark::State& state) { cycle(state, 3); }
void BM_Cycle_Method4(benchmark::State& state) { cycle(state, 4); }
void BM_Cycle_Method5(benchmark::State& state) { cycle(state, 5); }
BENCHMARK(BM_Cycle_Method1)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Cycle_Method2)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Cycle_Method3)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Cycle_Method4)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Cycle_Method5)->Unit(benchmark::kMillisecond);

/** Case S1 from start to end, simulator (Methods 3 and 4: with depth of 320x240) and planner;
 * simulated seconds a second. */
void BM_ClosedLoop_S1(benchmark::State& state) {
  const SimulationSetup setup = s1(static_cast<int>(state.range(0)));
  double simulated_s = 0.0;
  for (auto _ : state) simulated_s += runSimulation(setup, 1).duration_s;
  state.counters["times_real_time"] = benchmark::Counter(simulated_s, benchmark::Counter::kIsRate);
}
BENCHMARK(BM_ClosedLoop_S1)->DenseRange(1, 4)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bslnav
