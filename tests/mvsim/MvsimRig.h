#pragma once

#include <bslnav/mvsim/MvsimSimulator.h>

namespace bslnav::test {

/** A room of 6 m x 5 m with a turned box, a pole and a person, seen by a laser without noise from
 * a place off its middle. */
inline SimulationCase room() {
  SimulationCase simulated;
  simulated.world.walls["room"].points_m = {{-2, -2.5}, {4, -2.5}, {4, 2.5}, {-2, 2.5}, {-2, -2.5}};
  simulated.world.boxes["box"] = {{1.5, -1.0, 0.5}, 0.8, 0.4, 0.0, 1.0, true};
  simulated.world.cylinders["pole"] = {1.0, 1.5, 0.1, 0.0, 2.0, true};
  simulated.world.pedestrians["walker"].path_m = {{2.5, 1.0}, {2.5, -1.5}};
  simulated.world.pedestrians["walker"].speed_mps = 1.0;
  auto& laser = simulated.lasers["front"];
  laser.noiseStd_m = laser.dropoutProbability = 0.0;
  laser.x_m = 0.1;
  laser.yaw_rad = 0.2;
  simulated.start = {0.3, 0.2, 0.4};
  return simulated;
}

}  // namespace bslnav::test
