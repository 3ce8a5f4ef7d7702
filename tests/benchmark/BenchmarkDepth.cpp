#include <benchmark/benchmark.h>
#include <bslnav/blindspot/DepthClusterDetector.h>
#include <bslnav/blindspot/HiddenPeople.h>
#include <bslnav/blindspot/PersonVisibility.h>
#include <bslnav/costmap/DepthScan.h>
#include <bslnav/evaluation/SimulationSetup.h>
#include <bslnav/simulation/DepthCamera.h>

namespace bslnav {
namespace {

/** The camera's view of S1 from before the opening, 640x480. */
DepthCamera::Frame::ConstPtr picture() {
  SimulationSetup setup;
  Config config;
  setup.bind(config);
  config.load({dataDirectory() + "/config/scenarios/s1.ini"});
  DepthCameraParameters parameters = setup.cameras.at("front");
  parameters.columns = 640;
  parameters.rows = 480;
  DepthCamera camera("front", parameters, 1);
  RayScene scene(setup.world, {});
  return camera.frame(scene, {3.0, 0.0, 0.0}, mrpt::Clock::fromDouble(1e9));
}

DepthFrame frame() {
  DepthFrame taken;
  taken.assign(*picture());
  return taken;
}

void BM_DepthFrame_Assign(benchmark::State& state) {
  const auto image = picture();
  DepthFrame taken;
  for (auto _ : state) taken.assign(*image);
}
void BM_DepthScan_Make(benchmark::State& state) {
  const DepthFrame taken = frame();
  DepthScan scan;
  for (auto _ : state) benchmark::DoNotOptimize(scan.make(taken).hits());
}
void BM_PersonVisibility_Make(benchmark::State& state) {
  const DepthFrame taken = frame();
  PersonVisibility visibility;
  for (auto _ : state) benchmark::DoNotOptimize(visibility.make(taken).hits());
}
/** From an image to the places from which people step out, seen by the camera alone. */
void BM_PersonVisibility_Frontier(benchmark::State& state) {
  const DepthFrame taken = frame();
  PersonVisibility visibility;
  HiddenPeople hidden({}, 0.25, nullptr, {});
  std::vector<const PlanarScan*> views;
  double time_s = 0.0;
  for (auto _ : state) {
    views.assign(1, &visibility.make(taken));
    hidden.update(views, time_s += 0.1, {3.0, 0.0, 0.0}, 1.1);
  }
  state.counters["points"] = static_cast<double>(hidden.frontier().size());
}
void BM_VoxelClusters_Cluster(benchmark::State& state) {
  const DepthFrame taken = frame();
  VoxelClusters clusters{DepthClusterParameters{}};
  std::size_t voxels = 0;
  for (auto _ : state) voxels = clusters.cluster({&taken}).points.size();
  state.counters["voxels"] = static_cast<double>(voxels);
}
BENCHMARK(BM_DepthFrame_Assign)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_DepthScan_Make)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_PersonVisibility_Make)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_PersonVisibility_Frontier)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_VoxelClusters_Cluster)->Unit(benchmark::kMillisecond);

/** The same with PCL, stage by stage. */
void BM_Pcl_VoxelGrid(benchmark::State& state) {
  const PointCloud points = frame().points();
  for (auto _ : state) benchmark::DoNotOptimize(voxelGrid(points, 0.05, 1).size());
}
void BM_Pcl_PassThrough(benchmark::State& state) {
  const PointCloud voxels = voxelGrid(frame().points(), 0.05, 1);
  for (auto _ : state) benchmark::DoNotOptimize(passThrough(voxels, 0.1, 1.8).size());
}
void BM_Pcl_Clusters(benchmark::State& state) {
  const PointCloud kept = passThrough(voxelGrid(frame().points(), 0.05, 1), 0.1, 1.8);
  for (auto _ : state) benchmark::DoNotOptimize(euclideanClusters(kept, 0.15, 200).clusters);
}
BENCHMARK(BM_Pcl_VoxelGrid)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Pcl_PassThrough)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Pcl_Clusters)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace bslnav
