// Drives through a tiny world for three seconds, with the libraries alone: no files, no program of
// bslnav.
#include <bslnav/evaluation/SimulationRun.h>

#include <cstdio>

int main() {
  bslnav::SimulationSetup setup;
  setup.world.walls["room"].points_m = {{-1, -2}, {5, -2}, {5, 2}, {-1, 2}, {-1, -2}};
  setup.world.boxes["crate"].pose = {2.5, -0.8, 0.0};
  setup.lasers["front"] = bslnav::LaserParameters{};
  setup.scenario.goals = {{4.0, 0.0, 0.0}};
  setup.navigation.blindSpots.source = bslnav::BlindSpotSource::ScanJumps;

  const auto threeSeconds = [](const bslnav::SimulationMoment& moment) {
    return moment.record.time_s < 3.0;
  };
  const bslnav::RunSummary summary = bslnav::runSimulation(setup, 1, threeSeconds);
  std::printf("%d cycles, the robot drove %.3f m, %.1f blind spots a cycle\n", summary.cycles,
              summary.pathLength_m, summary.blindSpotsMean);
  return summary.contact ? 1 : 0;
}
