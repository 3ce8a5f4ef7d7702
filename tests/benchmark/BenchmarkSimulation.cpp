#include <benchmark/benchmark.h>
#include <bslnav/simulation/Simulator.h>

#include <string>

namespace bslnav {
namespace {

/** A corridor with an opening, 20 poles and a person, as in the paper's scenarios. */
WorldParameters corridor() {
  WorldParameters world;
  world.walls["left"].points_m = {{-1, 2}, {12, 2}};
  world.walls["right"].points_m = {{-1, -0.7}, {4.8, -0.7}, {4.8, -4}};
  world.walls["right2"].points_m = {{6.2, -4}, {6.2, -0.7}, {12, -0.7}};
  for (int i = 0; i < 20; ++i)
    world.cylinders[std::to_string(i)] = {0.5 * i, i % 2 ? 1.6 : 1.2, 0.05, 0.0, 1.0, true};
  world.pedestrians["person"].path_m = {{5.5, -3.2}, {5.5, -0.4}};
  return world;
}

void BM_Laser_Scan(benchmark::State& state) {
  LaserParameters parameters;
  parameters.beams = static_cast<int>(state.range(0));
  LaserSensor laser("laser", parameters, 1);
  RayScene scene(corridor(), {{0.25, 1.7}});
  scene.placePeople({{5.5, -0.4}});
  const auto stamp = mrpt::Clock::fromDouble(Simulator::kEpoch_s);
  for (auto _ : state) benchmark::DoNotOptimize(laser.scan(scene, {2.0, 0.0, 0.0}, stamp));
}
BENCHMARK(BM_Laser_Scan)->Arg(683)->Arg(1080);

/** A frame of 4:3 with noise, dropouts and edges, from the middle of the corridor. */
void BM_DepthCamera_Frame(benchmark::State& state) {
  DepthCameraParameters parameters;
  parameters.columns = static_cast<int>(state.range(0));
  parameters.rows = parameters.columns * 3 / 4;
  DepthCamera camera("camera", parameters, 1);
  RayScene scene(corridor(), {{0.25, 1.7}});
  scene.placePeople({{5.5, -0.4}});
  const auto stamp = mrpt::Clock::fromDouble(Simulator::kEpoch_s);
  for (auto _ : state) benchmark::DoNotOptimize(camera.frame(scene, {2.0, 0.0, 0.0}, stamp));
}
BENCHMARK(BM_DepthCamera_Frame)->Arg(320)->Arg(640)->Unit(benchmark::kMillisecond);

/** A control period: ten substeps of 10 ms and one scan of 683 beams. */
void BM_Simulator_Step(benchmark::State& state) {
  Simulator simulator(corridor(), {}, {{"laser", LaserParameters{}}}, {}, {2.0, 0.0, 0.0}, {}, 1);
  double omega = 0.5;
  for (auto _ : state) {
    simulator.step({0.0, 0.0, omega = -omega}, 0.1);
    benchmark::DoNotOptimize(simulator.senseScans());
  }
}
BENCHMARK(BM_Simulator_Step);

}  // namespace
}  // namespace bslnav
