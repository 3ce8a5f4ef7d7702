#include <bslnav/planning/DwaParameters.h>

namespace bslnav {

void CostWeights::describe(ConfigSection& section) {
  section.number("weight_path", path, kNonNegative, "1/m",
                 "W_pos: weight of the distance to the global path");
  section.number("weight_goal", goal, kNonNegative, "1/m",
                 "W_gol: weight of the distance to the local goal");
  section.number("weight_danger", danger, kNonNegative, "",
                 "W_dan: weight of the highest cost along the rollout");
  section.number("weight_velocity", velocity, kNonNegative, "m/s",
                 "W_vel: weight of 1/v; the paper's is 0.5");
  section.number("weight_movers", movers, kNonNegative, "",
                 "W_mov: weight of being in the way of people who are seen walking");
  section.number("danger_divisor", dangerDivisor, {1.0, 255.0}, "",
                 "c_dan is the highest cost divided by this");
  section.number("speed_floor_mps", speedFloor_mps, {0.001, 10.0}, "m/s",
                 "c_vel = 1/max(v, floor)");
}

void DwaParameters::describe(ConfigSection& section) {
  section.number("horizon_s", horizon_s, {0.1, 30.0}, "s",
                 "T_pre: how far ahead a candidate is driven");
  section.number("step_s", step_s, {0.01, 1.0}, "s",
                 "longest time step of a rollout; never passes over a cell");
  section.number("window_s", window_s, {0.01, 10.0}, "s",
                 "velocities that can be reached within this time are candidates");
  section.integer("speed_samples", speedSamples, {2, 500}, "", "speeds in the dynamic window");
  section.integer("yaw_rate_samples", yawRateSamples, {1, 500}, "",
                  "turning rates in the dynamic window");
  section.integer("lateral_samples", lateralSamples, {1, 500}, "",
                  "lateral speeds in the dynamic window, when the robot can move sideways");
  section.flag("allow_unknown", allowUnknown,
               "whether a rollout may cross unknown cells and leave the map");
  weights.describe(section);
  oscillation.describe(section);
}

}  // namespace bslnav
